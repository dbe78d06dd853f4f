// SPDX-License-Identifier: MIT
#include "options/method_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/error.hpp"
#include "methods/methods.hpp"

namespace raytorus::options {

namespace {

constexpr const char* reference = "reference";

void addOption(CLI::App& command, std::string& name, const std::string& names) {
    command.add_option("--method", name, "Who intersects, to compare: " + names)
        ->option_text(fmt::format("NAME [{}]", methods().front().name));
}

}  // namespace

void addMethodOption(CLI::App& command, std::string& name) {
    addOption(command, name, methodNames());
}

void addMethodOrReferenceOption(CLI::App& command, std::string& name) {
    addOption(command, name, fmt::format("{}; {}: in 113 bits, on the CPU", methodNames(), reference));
}

bool isReference(const std::string& method, const DeviceOptions& device) {
    if (method != reference) {
        return false;
    }
    const bool asksForDevice =
        !device.context.device.empty() || device.context.validate || !device.shaderFolder.empty();
    if (asksForDevice) {
        throw Error(ExitCode::Usage,
                    "--method reference runs on no device: not with --device, --validate or --shaders");
    }
    return true;
}

trace::ShaderSource shadersOf(const std::string& method, const DeviceOptions& device) {
    const Method* found = method.empty() ? &methods().front() : findMethod(method);
    if (found == nullptr) {
        throw Error(ExitCode::Usage,
                    fmt::format("--method: there is no method \"{}\" (there are {})", method, methodNames()));
    }
    if (found == &methods().front()) {
        return device.shaders();
    }
    if (!device.shaderFolder.empty()) {
        throw Error(
            ExitCode::Usage,
            fmt::format("--shaders replaces the shaders of the library, not those of --method {}", method));
    }
    return found->shaders;
}

}  // namespace raytorus::options
