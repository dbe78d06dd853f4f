// SPDX-License-Identifier: MIT
// Where the host's shaders come from: built in, or from a folder, for trying a changed shader without a new
// build, or others built in beside them, for comparing methods, or compiled a moment ago.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::trace {

class ShaderSource {
public:
    /// The built-in shaders.
    ShaderSource() = default;
    /// `<folder>/<name>.spv` instead, for each shader that is asked for.
    explicit ShaderSource(std::filesystem::path shaderFolder) : folder(std::move(shaderFolder)) {}

    /// What `find` knows instead of the built-in shader of that name; it returns nothing for those to keep.
    using Find = std::span<const std::uint32_t> (*)(std::string_view name);
    explicit ShaderSource(Find find) : replacements(find) {}

    /// SPIR-V by name, instead of the built-in shaders of these names.
    using Modules = std::map<std::string, std::vector<std::uint32_t>, std::less<>>;
    explicit ShaderSource(std::shared_ptr<const Modules> compiled) : modules(std::move(compiled)) {}

    /// SPIR-V of a shader by file name ("scene.frag"). Throws Error{File} if the folder has no such file.
    [[nodiscard]] std::vector<std::uint32_t> load(const std::string& name) const;

private:
    std::filesystem::path folder;  // empty: built in
    Find replacements = nullptr;
    std::shared_ptr<const Modules> modules;
};

}  // namespace raytorus::trace
