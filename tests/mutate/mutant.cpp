// SPDX-License-Identifier: MIT
#include "mutate/mutant.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "methods/methods.hpp"
#include "raytorus_test_shaders.hpp"
#include "support/run_program.hpp"

namespace raytorus::mutate {
namespace {

namespace fs = std::filesystem;

const fs::path sourceFolder = RAYTORUS_SOURCE_DIR;

constexpr const char* fastFolder = "fast";

// The command of shaders/CompileShader.cmake, with a folder for the output and a -D or none.
void compile(const fs::path& source, const fs::path& include, const fs::path& output, const char* mutation,
             const std::vector<std::string>& define = {}) {
    const std::string name = source.filename().string();
    std::vector<std::string> arguments = {"--quiet", "--target-env", "vulkan1.3", "-I" + include.string()};
    arguments.insert(arguments.end(), define.begin(), define.end());
    arguments.insert(arguments.end(), {"-o", (output / (name + ".spv")).string(), source.string()});
    const test::ProgramResult result = test::runProgram(RAYTORUS_GLSLANG, arguments);
    if (result.exitCode != 0) {
        throw Error(ExitCode::Shader, fmt::format("mutation {}: {} does not compile: {}", mutation, name,
                                                  result.out.substr(0, result.out.find('\n'))));
    }
}

}  // namespace

Mutant::Mutant(const Mutation* mutation, fs::path folder) : source(folder), fast(folder / fastFolder) {
    fs::remove_all(folder);
    fs::create_directories(folder / fastFolder);
    fs::copy(sourceFolder / "shaders", folder / "shaders", fs::copy_options::recursive);
    if (mutation != nullptr) {
        const fs::path file = folder / "shaders" / mutation->file;
        const std::string text = mutated(*mutation, readTextFile(file));
        writeFile(file, std::as_bytes(std::span(text)));
    }
    const char* name = mutation != nullptr ? mutation->name : "none";
    const fs::path shaders = folder / "shaders";
    for (const char* shader : {"fullscreen.vert", "scene.frag", "scene.comp", "trace.comp"}) {
        compile(shaders / shader, shaders, folder, name);
    }
    compile(sourceFolder / "tests" / "support" / "probe.comp", shaders, folder, name);
    compile(shaders / "trace.comp", shaders, folder / fastFolder, name, {"-DTORUS_FAST"});
}

bool Mutant::changes(const std::string& shader) const {
    const trace::ShaderSource unchanged =
        shader == "probe.comp" ? trace::ShaderSource(test_shaders::find) : trace::ShaderSource();
    return source.load(shader) != unchanged.load(shader);
}

bool Mutant::changesFast() const {
    return fast.load("trace.comp") != findMethod("raytorus-fast")->shaders.load("trace.comp");
}

}  // namespace raytorus::mutate
