// SPDX-License-Identifier: MIT
#include "shader_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/scratch_folder.hpp"

namespace raytorus::test {

ShaderFolder::ShaderFolder() : path(scratchFolder()) {}

std::filesystem::path ShaderFolder::write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path / name).parent_path());
    writeText(path / name, text);
    return path / name;
}

std::filesystem::path ShaderFolder::writeShader(const std::string& name, const std::string& rest) const {
    return write(name,
                 "#version 460\n"
                 "#extension GL_GOOGLE_include_directive : require\n"
                 "layout(local_size_x = 1) in;\n"
                 "layout(set = 0, binding = 0, std430) buffer Result { float x; };\n" +
                     rest);
}

compile::ShaderRequest ShaderFolder::request(const std::string& entry) const {
    return {path / entry, {path}, {}};
}

std::string errorsOf(const compile::CompiledShader& shader) {
    std::string text;
    for (const compile::CompileError& error : shader.errors) {
        text += compile::describe(error) + "\n";
    }
    return text;
}

std::vector<std::string> filesOf(const compile::CompiledShader& shader, const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const compile::FileState& file : shader.files) {
        EXPECT_TRUE(file.path.is_absolute()) << file.path;
        names.push_back(file.path.lexically_relative(folder).string() +
                        (std::filesystem::exists(file.path) ? "" : "?"));
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace raytorus::test
