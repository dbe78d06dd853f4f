// SPDX-License-Identifier: MIT
// Where the host's shaders come from: built in, or from a folder, for trying a changed shader without a new
// build, or one module put in the place of a built-in one, for comparing methods.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raytorus::render {

class ShaderSource {
public:
    /// The built-in shaders.
    ShaderSource() = default;
    /// `<folder>/<name>.spv` instead, for each shader that is asked for.
    explicit ShaderSource(std::filesystem::path shaderFolder) : folder(std::move(shaderFolder)) {}

    /// `module` instead of the built-in shader `name`; the others built in. `module` must outlive this.
    ShaderSource(std::string name, std::span<const std::uint32_t> module)
        : replacedName(std::move(name)), replacement(module) {}

    /// SPIR-V of a shader by file name ("scene.frag"). Throws Error{File} if the folder has no such file.
    [[nodiscard]] std::vector<std::uint32_t> load(const std::string& name) const;

private:
    std::filesystem::path folder;  // empty: built in
    std::string replacedName;
    std::span<const std::uint32_t> replacement;
};

}  // namespace raytorus::render
