// SPDX-License-Identifier: MIT
// The options that every command with a device has, and the device itself.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <string>

#include "gpu/context.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::options {

struct DeviceOptions {
    std::string program = "raytorus";  ///< whose name stands before what the validation layers say
    gpu::ContextOptions context;
    std::string shaderFolder;

    [[nodiscard]] trace::ShaderSource shaders() const;
};

/// --device, --validate, --timeout, --shaders.
void addDeviceOptions(CLI::App& command, DeviceOptions& options);

/// Makes the device, runs `work` on it, and takes it down again; then throws if the validation layers said
/// anything, be it while going down.
void withDevice(const DeviceOptions& options, const std::function<void(gpu::Context&)>& work);

}  // namespace raytorus::options
