// SPDX-License-Identifier: MIT
#include "golden/golden_options.hpp"

#include <fmt/format.h>

#include "core/shell_quote.hpp"
#include "trace/device_words.hpp"

namespace raytorus::golden {
namespace {

std::string folderOption(const std::string& folder) {
    return folder == CheckOptions().folder ? "" : shellOption("--folder", folder);
}

}  // namespace

std::string CheckOptions::checkCommand(const Case& row) const {
    std::string text =
        "raytorus golden check " + row.name + folderOption(folder) + trace::deviceWords(device, shaderFolder);
    if (toleranceFactor != CheckOptions().toleranceFactor) {
        text += fmt::format(" --tolerance-factor {}", toleranceFactor);
    }
    return text;
}

std::string CheckOptions::renewCommand(const Case& row) const {
    return "raytorus golden renew " + row.name + folderOption(folder) + " --reason \"...\"";
}

std::string CheckOptions::bitsCommand() const {
    return "raytorus golden bits" + folderOption(folder) + trace::deviceWords(device, shaderFolder) +
           " --reason \"...\"";
}

std::string CheckOptions::explainCommand(const std::filesystem::path& scene) const {
    return "raytorus explain" + shellOption("--scene", scene.string()) +
           trace::deviceWords(device, shaderFolder) + " --pixel {x},{y}";
}

std::string listCommand(const std::filesystem::path& folder) {
    return "raytorus golden list" + folderOption(folder.string());
}

}  // namespace raytorus::golden
