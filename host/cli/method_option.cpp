// SPDX-License-Identifier: MIT
#include "cli/method_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/methods/methods.hpp"
#include "core/error.hpp"

namespace raytorus::cli {

void addMethodOption(CLI::App& command, std::string& name) {
    command.add_option("--method", name, "Who intersects, to compare: " + methodNames())
        ->option_text(fmt::format("NAME [{}]", methods().front().name));
}

render::ShaderSource shadersOf(const std::string& method, const DeviceOptions& device) {
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

}  // namespace raytorus::cli
