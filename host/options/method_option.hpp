// SPDX-License-Identifier: MIT
// The option that says who intersects: the library, one of the methods that it is compared with, or the
// reference, which needs no device.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "options/device_options.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::options {

/// --method. `name` stays as it is for the library.
void addMethodOption(CLI::App& command, std::string& name);

/// The same where the reference can answer, too.
void addMethodOrReferenceOption(CLI::App& command, std::string& name);

/// Whether `method` is the reference. Throws Error{Usage} if options of a device are given to it.
bool isReference(const std::string& method, const DeviceOptions& device);

/// The shaders of the method, or those that --shaders names. Throws Error{Usage} if there is no such method,
/// or if both are given.
trace::ShaderSource shadersOf(const std::string& method, const DeviceOptions& device);

}  // namespace raytorus::options
