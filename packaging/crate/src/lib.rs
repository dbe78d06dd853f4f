// SPDX-License-Identifier: MIT
#![no_std]
#![doc = include_str!("../README.md")]

/// WGSL: the exact tier.
pub const RAYTORUS_WGSL: &str = include_str!("../shaders/exact.wgsl");
/// WGSL: the fast tier.
pub const RAYTORUS_FAST_WGSL: &str = include_str!("../shaders/fast.wgsl");
/// GLSL from 3.30, GLSL ES from 3.00 and Vulkan: both tiers.
pub const RAYTORUS_GLSL: &str = include_str!("../shaders/raytorus.glsl");
/// The version of the library.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
