// SPDX-License-Identifier: MIT
#include "trace/device_words.hpp"

#include <fmt/format.h>

#include "core/shell_quote.hpp"

namespace raytorus::trace {

std::string deviceWords(const gpu::ContextOptions& options, const std::string& shaderFolder) {
    const gpu::ContextOptions unless;
    std::string text;
    if (options.device != unless.device) {
        text += shellOption("--device", options.device);
    }
    if (options.validate) {
        text += " --validate";
    }
    if (options.timeoutSeconds != unless.timeoutSeconds) {
        text += fmt::format(" --timeout {}", options.timeoutSeconds);
    }
    if (!shaderFolder.empty()) {
        text += shellOption("--shaders", shaderFolder);
    }
    return text;
}

}  // namespace raytorus::trace
