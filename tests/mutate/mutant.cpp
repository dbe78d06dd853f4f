// SPDX-License-Identifier: MIT
#include "mutate/mutant.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "raytorus_test_shaders.hpp"
#include "run_program.hpp"

namespace raytorus::mutate {
namespace {

namespace fs = std::filesystem;

const fs::path sourceFolder = RAYTORUS_SOURCE_DIR;

// The command of shaders/CompileShader.cmake.
void compile(const std::string& name, const fs::path& source, const fs::path& folder, const char* mutation) {
    const test::ProgramResult result = test::runProgram(
        RAYTORUS_GLSLANG, {"--quiet", "--target-env", "vulkan1.3", "-I" + (folder / "shaders").string(), "-o",
                           (folder / (name + ".spv")).string(), source.string()});
    if (result.exitCode != 0) {
        throw Error(ExitCode::Shader, fmt::format("mutation {}: {} does not compile: {}", mutation, name,
                                                  result.out.substr(0, result.out.find('\n'))));
    }
}

}  // namespace

Mutant::Mutant(const Mutation* mutation, fs::path folder) : source(folder) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    fs::copy(sourceFolder / "shaders", folder / "shaders", fs::copy_options::recursive);
    if (mutation != nullptr) {
        const fs::path file = folder / "shaders" / mutation->file;
        const std::string text = mutated(*mutation, readTextFile(file));
        writeFile(file, std::as_bytes(std::span(text)));
    }
    const char* name = mutation != nullptr ? mutation->name : "none";
    for (const char* shader : {"fullscreen.vert", "scene.frag", "scene.comp", "trace.comp"}) {
        compile(shader, folder / "shaders" / shader, folder, name);
    }
    compile("probe.comp", sourceFolder / "tests" / "probe.comp", folder, name);
}

bool Mutant::changes(const std::string& shader) const {
    const render::ShaderSource unchanged =
        shader == "probe.comp" ? render::ShaderSource(test_shaders::find) : render::ShaderSource();
    return source.load(shader) != unchanged.load(shader);
}

}  // namespace raytorus::mutate
