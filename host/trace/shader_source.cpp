// SPDX-License-Identifier: MIT
#include "trace/shader_source.hpp"

#include <fmt/format.h>

#include <cstring>

#include "core/error.hpp"
#include "core/file.hpp"
#include "raytorus_shaders.hpp"

namespace raytorus::trace {

std::vector<std::uint32_t> ShaderSource::load(const std::string& name) const {
    if (folder.empty()) {
        std::span<const std::uint32_t> words;
        if (replacements != nullptr) {
            words = replacements(name);
        }
        if (modules != nullptr) {
            const auto found = modules->find(name);
            words = found != modules->end() ? std::span<const std::uint32_t>(found->second) : words;
        }
        if (words.empty()) {
            words = shaders::find(name);
        }
        if (words.empty()) {
            throw Error(ExitCode::Internal, fmt::format("the shader {} is not built in", name));
        }
        return {words.begin(), words.end()};
    }
    const std::filesystem::path path = folder / (name + ".spv");
    const std::vector<std::byte> bytes = readFile(path);
    if (bytes.size() % sizeof(std::uint32_t) != 0) {
        throw Error(ExitCode::Shader, fmt::format("{}: {} bytes are no whole number of SPIR-V words",
                                                  path.string(), bytes.size()));
    }
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

}  // namespace raytorus::trace
