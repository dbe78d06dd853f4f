// SPDX-License-Identifier: MIT
//! Takes the modules that the crate's wesl.toml names.
fn main() {
    let package = wesl::PkgBuilder::new("raytorus").scan_toml("crate").expect("crate/wesl.toml");
    package.build_artifact().expect("the generated module");
}
