// SPDX-License-Identifier: MIT
#include "options/device_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/console.hpp"
#include "options/numbers.hpp"

namespace raytorus::options {

trace::ShaderSource DeviceOptions::shaders() const {
    return shaderFolder.empty() ? trace::ShaderSource() : trace::ShaderSource(shaderFolder);
}

void addDeviceOptions(CLI::App& command, DeviceOptions& options) {
    command
        .add_option("--device", options.context.device,
                    "Device by number, or by a part of its name or driver (see raytorus doctor)")
        ->option_text("NAME");
    command.add_flag("--validate", options.context.validate,
                     "Run with the Vulkan validation layers; any message is an error (exit code 11)");
    command
        .add_option("--timeout", options.context.timeoutSeconds,
                    "Longest time for one piece of work on the device (exit code 10)")
        ->check(decimalNumber(1e-6, 1e6))
        ->option_text("SECONDS [120]");
    command
        .add_option("--shaders", options.shaderFolder, "Use DIR/<shader>.spv instead of the built-in shaders")
        ->option_text("DIR");
}

void withDevice(const DeviceOptions& options, const std::function<void(gpu::Context&)>& work) {
    const auto log = std::make_shared<gpu::ValidationLog>(
        [&](const std::string& message) { writeError(fmt::format("{}: {}\n", options.program, message)); });
    try {
        gpu::Context context(options.context, log);
        work(context);
    } catch (...) {
        // A message of the validation layers is the cause of what went wrong after it, so it goes first.
        log->requireEmpty();
        throw;
    }
    log->requireEmpty();
}

}  // namespace raytorus::options
