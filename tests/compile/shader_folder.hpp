// SPDX-License-Identifier: MIT
// A folder of shaders written by a test, and the ways to compile from it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compile/compile_shader.hpp"

namespace raytorus::test {

class ShaderFolder {
public:
    /// The scratch folder of the running test.
    ShaderFolder();

    /// Folders in between are made. Returns the file's path.
    std::filesystem::path write(const std::string& name, const std::string& text) const;

    /// A compute shader whose main() stands in the lines from 5 on, which are `rest`.
    std::filesystem::path writeShader(const std::string& name, const std::string& rest) const;

    /// The request for an entry in this folder, which is the only root.
    [[nodiscard]] compile::ShaderRequest request(const std::string& entry) const;

    [[nodiscard]] compile::CompiledShader compile(const std::string& entry) const {
        return compile::compileShader(request(entry));
    }

    std::filesystem::path path;
};

/// "file:line: text" of every error, one a line.
std::string errorsOf(const compile::CompiledShader& shader);

/// The names of its files relative to the folder, sorted; those that are missing with a "?" after them.
std::vector<std::string> filesOf(const compile::CompiledShader& shader, const std::filesystem::path& folder);

}  // namespace raytorus::test
