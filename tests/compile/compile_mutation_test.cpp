// SPDX-License-Identifier: MIT
// The library's shaders damaged at random, as half-written files and slips of the keyboard damage them: each
// has an error in one of its files, or compiles; none crashes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compile/compile_shader.hpp"
#include "shader_folder.hpp"
#include "support/fresh_seed.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

namespace fs = std::filesystem;

const fs::path shaderFolder = fs::path(RAYTORUS_SOURCE_DIR) / "shaders";

int lineCount(const std::string& text) {
    return 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// Every error lies in a file of the shader, on a line that it has.
void expectPlaced(const CompiledShader& shader, const fs::path& folder) {
    for (const CompileError& error : shader.errors) {
        ASSERT_TRUE(fs::is_regular_file(folder / error.file)) << describe(error);
        // One more: what is found missing at the end of a file may be told on the line after it.
        EXPECT_LE(error.line, lineCount(test::fileText(folder / error.file)) + 1) << describe(error);
        EXPECT_FALSE(error.text.empty());
        EXPECT_FALSE(error.text.starts_with("the compilation ")) << describe(error) << ": glslang crashed";
    }
}

struct CompileDamaged : testing::Test {
    CompileDamaged() {
        for (const auto& entry : fs::recursive_directory_iterator(shaderFolder)) {
            if (entry.is_regular_file()) {
                const fs::path name = entry.path().lexically_relative(shaderFolder);
                folder.write(name.string(), test::fileText(entry.path()));
            }
        }
    }
    test::ShaderFolder folder;
};

TEST_F(CompileDamaged, CutOffAnywhere) {
    std::mt19937_64 random(test::freshSeed());
    int refused = 0;
    for (const char* name : {"trace.comp", "torus/torus.glsl", "torus/refine.glsl", "trace_io.h"}) {
        const std::string whole = test::fileText(shaderFolder / name);
        for (int i = 0; i < 60; ++i) {
            const auto size = std::uniform_int_distribution<std::size_t>(0, whole.size() - 2)(random);
            SCOPED_TRACE(std::string(name) + " cut to " + std::to_string(size));
            folder.write(name, whole.substr(0, size));
            const CompiledShader shader = folder.compile("trace.comp");
            refused += shader.ok() ? 0 : 1;
            expectPlaced(shader, folder.path);
        }
        folder.write(name, whole);
        EXPECT_TRUE(folder.compile("trace.comp").ok());
    }
    EXPECT_GE(refused, 200) << "only a cut in what is not needed may compile";
}

TEST_F(CompileDamaged, BytesChangedAnywhere) {
    std::mt19937_64 random(test::freshSeed());
    const std::string bytes = std::string("(){}[];,.#/*\\\"'<>=!&|+-~?:@ \n\r\t01fxe\x7f\xc3\xff", 40);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        const std::string name =
            std::vector{"trace.comp", "torus/torus.glsl", "torus/refine.glsl", "method.glsl"}[random() % 4];
        const std::string whole = test::fileText(shaderFolder / name);
        std::string damaged = whole;
        for (auto count = 1 + random() % 4; count-- > 0;) {
            const std::size_t at = random() % damaged.size();
            const char byte = bytes[random() % bytes.size()];
            switch (random() % 4) {
                case 0:
                    damaged[at] = byte;
                    break;
                case 1:
                    damaged.insert(at, 1, byte);
                    break;
                case 2:
                    damaged.erase(at, 1 + random() % 20);
                    break;
                default:
                    damaged.insert(at, whole.substr(random() % whole.size(), random() % 200));
            }
        }
        folder.write(name, damaged);
        const CompiledShader shader = folder.compile("trace.comp");
        refused += shader.ok() ? 0 : 1;
        expectPlaced(shader, folder.path);
        if (testing::Test::HasFailure()) {
            FAIL() << "the damaged shaders are in " << folder.path;
        }
        folder.write(name, whole);
    }
    EXPECT_GE(refused, 100);
}

}  // namespace
}  // namespace raytorus::compile
