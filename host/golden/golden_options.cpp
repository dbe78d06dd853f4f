// SPDX-License-Identifier: MIT
#include "golden/golden_options.hpp"

#include <fmt/format.h>

#include "core/shell_quote.hpp"

namespace raytorus::golden {
namespace {

std::string option(std::string_view name, const std::string& value) {
    // By itself a value that begins with '-' would be taken for an option.
    return fmt::format(" {}{}{}", name, value.starts_with('-') ? '=' : ' ', shellQuote(value));
}

std::string folderOption(const std::string& folder) {
    return folder == CheckOptions().folder ? "" : option("--folder", folder);
}

std::string deviceOptions(const CheckOptions& options) {
    const gpu::ContextOptions unless;
    std::string text;
    if (options.device.device != unless.device) {
        text += option("--device", options.device.device);
    }
    if (options.device.validate) {
        text += " --validate";
    }
    if (options.device.timeoutSeconds != unless.timeoutSeconds) {
        text += fmt::format(" --timeout {}", options.device.timeoutSeconds);
    }
    if (!options.shaderFolder.empty()) {
        text += option("--shaders", options.shaderFolder);
    }
    return text;
}

}  // namespace

std::string CheckOptions::checkCommand(const Case& row) const {
    std::string text = "raytorus golden check " + row.name + folderOption(folder) + deviceOptions(*this);
    if (toleranceFactor != CheckOptions().toleranceFactor) {
        text += fmt::format(" --tolerance-factor {}", toleranceFactor);
    }
    return text;
}

std::string CheckOptions::renewCommand(const Case& row) const {
    return "raytorus golden renew " + row.name + folderOption(folder) + " --reason \"...\"";
}

std::string CheckOptions::bitsCommand() const {
    return "raytorus golden bits" + folderOption(folder) + deviceOptions(*this) + " --reason \"...\"";
}

std::string CheckOptions::explainCommand(const std::filesystem::path& scene) const {
    return "raytorus explain" + option("--scene", scene.string()) + deviceOptions(*this) + " --pixel {x},{y}";
}

std::string listCommand(const std::filesystem::path& folder) {
    return "raytorus golden list" + folderOption(folder.string());
}

}  // namespace raytorus::golden
