// SPDX-License-Identifier: MIT
// The numeric tests as judges of changed shaders: the contract's checks, the surface functions' checks, and
// the verifier's bars on rays of every class.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gpu/context.hpp"
#include "render/shader_source.hpp"

namespace raytorus::mutate {

struct RayChoice {
    std::uint64_t seed = 1;
    std::uint64_t perCell = 500;
};

/// The first check that fails with these shaders, and what it says; nothing if each passes. Without a
/// mutant's change in trace.comp, probe.comp or scene.frag the checks of that shader are left out.
struct Asked {
    bool rays = true;
    bool surface = true;
    bool pictures = true;
};
std::optional<std::string> caughtByNumbers(gpu::Context& context, const render::ShaderSource& shaders,
                                           const RayChoice& rays, const Asked& asked = {});

}  // namespace raytorus::mutate
