// SPDX-License-Identifier: MIT
//! Shaders with raytorus, as text and by WESL, which naga must find valid.
use naga::valid::{Capabilities, ValidationFlags, Validator};

wesl::wesl_pkg!(raytorus_modules, "raytorus.rs");

const USE: &str = "
@group(0) @binding(0) var<storage, read_write> depth: f32;
@compute @workgroup_size(1) fn main() {
    var hit: TorusHit;
    let found = torusIntersect(Torus(1.0, 0.25), vec3f(3.0, 0.0, 0.0), 0.0, vec3f(-1.0, 0.0, 0.0), 9.0, &hit);
    depth = select(-1.0, hit.t, found);
}";

fn validate(name: &str, text: &str) {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).expect(name);
    assert_eq!(1, module.entry_points.len(), "{name}");
    println!("{name}: {} functions", module.functions.len());
}

fn main() {
    validate("RAYTORUS_WGSL", &[raytorus::RAYTORUS_WGSL, USE].concat());
    validate("RAYTORUS_FAST_WGSL", &[raytorus::RAYTORUS_FAST_WGSL, USE].concat());
    for name in ["exact", "fast"] {
        let mut compiler = wesl::Wesl::new("shaders");
        compiler.add_package(&raytorus_modules::PACKAGE);
        let path = format!("package::{name}").parse().expect("a module's path");
        let shader = compiler.compile(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
        validate(&format!("raytorus::{name}"), &shader.to_string());
    }
    println!("raytorus {}", raytorus::VERSION);
}
