// SPDX-License-Identifier: MIT
// What compiles: the project's own shaders to the very words that the build embeds, by methods and macros
// too, from any thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "compile/compile_shader.hpp"
#include "methods/methods.hpp"
#include "raytorus_shaders.hpp"
#include "shader_folder.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using test::errorsOf;
using test::filesOf;
using test::ShaderFolder;

const std::filesystem::path projectRoot = RAYTORUS_SOURCE_DIR;

ShaderRequest shipped(const std::string& name) {
    return {projectRoot / "shaders" / name, {projectRoot / "shaders"}, {}};
}

// As shaders/CompileShader.cmake's METHOD does.
ShaderRequest withMethod(const std::string& name, std::string method) {
    std::replace(method.begin(), method.end(), '-', '_');
    ShaderRequest request = shipped(name);
    request.roots.push_back(projectRoot / "host/methods");
    request.defines.push_back({"OTHER_METHOD", ""});
    const ShaderFolder own;
    own.write("other_method.glsl", "#include \"" + method + ".glsl\"\n");
    request.roots.push_back(own.path);
    return request;
}

TEST(Compile, ShippedShadersHaveTheWordsThatTheBuildEmbeds) {
    for (const char* name : {"explain.comp", "fullscreen.vert", "scene.comp", "scene.frag", "trace.comp"}) {
        const CompiledShader shader = compileShader(shipped(name));
        const auto embedded = shaders::find(name);
        ASSERT_FALSE(embedded.empty()) << name;
        EXPECT_EQ(shader.words, std::vector(embedded.begin(), embedded.end())) << name << "\n"
                                                                               << errorsOf(shader);
        EXPECT_TRUE(shader.ok()) << errorsOf(shader);
    }
}

TEST(Compile, OtherMethodsHaveTheWordsThatTheBuildEmbeds) {
    int compared = 0;
    for (const Method& method : methods().subspan(1)) {
        if (method.tier) {
            continue;  // the library's own, with a define
        }
        for (const char* name : {"scene.comp", "scene.frag", "trace.comp"}) {
            const CompiledShader shader = compileShader(withMethod(name, method.name));
            EXPECT_EQ(shader.words, method.shaders.load(name)) << method.name << ", " << name << "\n"
                                                               << errorsOf(shader);
            EXPECT_NE(shader.words, methods()[0].shaders.load(name)) << method.name;
            ++compared;
        }
    }
    EXPECT_GE(compared, 18);
}

TEST(Compile, FilesAreThoseThatWereReadAndThoseThatWouldGoBefore) {
    const auto folder = projectRoot / "shaders";
    EXPECT_EQ(filesOf(compileShader(shipped("fullscreen.vert")), folder),
              std::vector<std::string>{"fullscreen.vert"});
    const CompiledShader trace = compileShader(shipped("trace.comp"));
    EXPECT_EQ(trace.files.front().path, folder / "trace.comp");
    const std::vector<std::string> read = filesOf(trace, folder);
    for (const char* name : {"method.glsl", "torus/torus.glsl", "torus/refine.glsl", "trace_io.h"}) {
        EXPECT_TRUE(std::binary_search(read.begin(), read.end(), name)) << name;
    }
    for (const FileState& file : trace.files) {
        EXPECT_EQ(file.fingerprint, fingerprint(readSourceFile(file.path))) << file.path;
    }
}

TEST(Compile, MacrosAreDefinedBeforeTheFirstLine) {
    const ShaderFolder folder;
    folder.writeShader("a.comp", "void main() { x = VALUE + float(defined_empty_ok); }\n");
    folder.writeShader("b.comp",
                       "#ifdef EMPTY\n#define defined_empty_ok 1\n#endif\n"
                       "void main() { x = VALUE + float(defined_empty_ok); }\n");
    ShaderRequest request = folder.request("b.comp");
    EXPECT_EQ(compileShader(request).ok(), false);
    request.defines = {{"VALUE", "2.5"}, {"EMPTY", ""}};
    const CompiledShader shader = compileShader(request);
    EXPECT_TRUE(shader.ok()) << errorsOf(shader);
    request.defines[0].value = "3.5";
    EXPECT_NE(compileShader(request).words, shader.words);
}

TEST(Compile, MacrosThatAreNoneAreRefused) {
    const ShaderFolder folder;
    folder.writeShader("a.comp", "void main() {}\n");
    ShaderRequest request = folder.request("a.comp");
    for (const char* name : {"", "2D", "A B", "A\nB", "A(x)", "A=1"}) {
        request.defines = {{name, ""}};
        const CompiledShader shader = compileShader(request);
        ASSERT_FALSE(shader.ok()) << name;
        EXPECT_NE(errorsOf(shader).find("is no name of a macro"), std::string::npos) << errorsOf(shader);
    }
    for (const char* value : {"1\n#error", "1\\", "\r"}) {
        request.defines = {{"A", value}};
        EXPECT_EQ(errorsOf(compileShader(request)), "a.comp: the value of the macro A is not one line\n");
    }
    request.defines = {{"TWICE", "1"}, {"TWICE", "2"}};
    const std::string errors = errorsOf(compileShader(request));
    EXPECT_TRUE(errors.starts_with("the given macros:2: ")) << errors;
}

TEST(Compile, StageIsTheExtensions) {
    const ShaderFolder folder;
    const std::string text =
        "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1); }\n";
    folder.write("a.frag", text);
    folder.write("a.vert", text);
    folder.write("a.glsl", text);
    EXPECT_TRUE(folder.compile("a.frag").ok());
    EXPECT_TRUE(folder.compile("a.vert").ok());
    EXPECT_NE(folder.compile("a.frag").words, folder.compile("a.vert").words);
    const CompiledShader none = folder.compile("a.glsl");
    EXPECT_EQ(errorsOf(none),
              "a.glsl: the stage is not known: .vert, .frag or .comp must end the file's name\n");
    EXPECT_EQ(none.files.size(), 1U);
}

TEST(Compile, NothingOfOneCompilationIsLeftToTheNext) {
    const ShaderFolder folder;
    folder.writeShader("good.comp", "float f() { return 1.0; }\nvoid main() { x = f(); }\n");
    folder.writeShader("bad.comp", "float f() { return\n");
    const std::vector<std::uint32_t> words = folder.compile("good.comp").words;
    ASSERT_FALSE(words.empty());
    for (int i = 0; i < 3; ++i) {
        EXPECT_FALSE(folder.compile("bad.comp").ok());
        EXPECT_EQ(folder.compile("good.comp").words, words);
    }
}

TEST(Compile, FromSeveralThreadsAtOnce) {
    const ShaderFolder folder;
    folder.writeShader("bad.comp", "\nvoid main() { x = missing; }\n");
    const auto embedded = shaders::find("trace.comp");
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < 5; ++k) {
                const CompiledShader trace = compileShader(shipped("trace.comp"));
                EXPECT_TRUE(
                    std::equal(trace.words.begin(), trace.words.end(), embedded.begin(), embedded.end()));
                EXPECT_EQ(errorsOf(folder.compile("bad.comp")),
                          "bad.comp:6: 'missing' : undeclared identifier\n");
            }
        });
    }
}

TEST(Compile, RelativePathsAreThoseOfTheWorkingFolder) {
    const ShaderFolder folder;
    folder.write("inc/a.glsl", "float f() { return 1.0; }\n");
    folder.writeShader("sub/e.comp", "#include \"a.glsl\"\nvoid main() { x = f() }\n");
    const auto here = std::filesystem::relative(folder.path);
    const CompiledShader shader = compileShader({here / "sub/e.comp", {here / "inc"}, {}});
    EXPECT_EQ(shader.errors.front().file, (here / "sub/e.comp").string());
    EXPECT_EQ(filesOf(shader, folder.path),
              (std::vector<std::string>{"inc/a.glsl", "sub/a.glsl?", "sub/e.comp"}));
}

}  // namespace
}  // namespace raytorus::compile
