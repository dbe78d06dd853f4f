// SPDX-License-Identifier: MIT
// The options of a check, and the commands that do one thing more under the same options. They are pasted
// into shells: each word is quoted where it needs to be.
#pragma once

#include <string>

#include "golden/golden_set.hpp"
#include "gpu/context.hpp"

namespace raytorus::golden {

struct CheckOptions {
    std::string folder = "golden";
    gpu::ContextOptions device;  ///< as the command line gives it: name, validation, time limit
    std::string shaderFolder;    ///< empty: the built-in shaders
    float toleranceFactor = 1.0F;

    /// Makes and compares a case again.
    [[nodiscard]] std::string checkCommand(const Case& row) const;
    /// Makes its truth anew. The reason is for the reader to fill in.
    [[nodiscard]] std::string renewCommand(const Case& row) const;
    /// Records what CPU drivers draw.
    [[nodiscard]] std::string bitsCommand() const;
    /// Explains a pixel of a scene; ends with "{x},{y}" for it.
    [[nodiscard]] std::string explainCommand(const std::filesystem::path& scene) const;
};

/// "raytorus golden list", of this folder.
[[nodiscard]] std::string listCommand(const std::filesystem::path& folder);

}  // namespace raytorus::golden
