// SPDX-License-Identifier: MIT
// The option that says who intersects: the library, or one of the methods that it is compared with.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/device_options.hpp"
#include "render/shader_source.hpp"

namespace raytorus::cli {

/// --method. `name` stays empty for the library.
void addMethodOption(CLI::App& command, std::string& name);

/// The shaders of the method, or those that --shaders names. Throws Error{Usage} if there is no such method,
/// or if both are given.
render::ShaderSource shadersOf(const std::string& method, const DeviceOptions& device);

}  // namespace raytorus::cli
