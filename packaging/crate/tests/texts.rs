// SPDX-License-Identifier: MIT
//! The texts are the library, each whole and of this version.
use raytorus::{RAYTORUS_FAST_WGSL, RAYTORUS_GLSL, RAYTORUS_WGSL, VERSION};

const FUNCTIONS: [&str; 4] = ["torusIntersect(", "torusOccluded(", "torusIntersectAll(", "torusNormal("];

fn depth(text: &str) -> i32 {
    text.chars().map(|c| (c == '{') as i32 - (c == '}') as i32).sum()
}

#[test]
fn every_text_has_the_public_functions_and_ends_where_it_should() {
    for text in [RAYTORUS_WGSL, RAYTORUS_FAST_WGSL, RAYTORUS_GLSL] {
        for function in FUNCTIONS {
            assert!(text.contains(function), "{function} is missing");
        }
        assert_eq!(0, depth(text));
        assert!(text.contains("SPDX-License-Identifier: MIT"));
    }
    assert_ne!(RAYTORUS_WGSL, RAYTORUS_FAST_WGSL);
}

#[test]
fn the_version_is_that_of_the_library() {
    for (name, number) in ["MAJOR", "MINOR", "PATCH"].iter().zip(VERSION.split('.')) {
        assert!(RAYTORUS_GLSL.contains(&format!("#define TORUS_VERSION_{name} {number}\n")));
    }
}
