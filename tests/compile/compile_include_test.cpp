// SPDX-License-Identifier: MIT
// Which files are included: found as glslangValidator -I finds them, in cycles only behind guards, and never
// from outside the shader folders.
#include <gtest/gtest.h>

#include "compile/compile_shader.hpp"
#include "shader_folder.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using test::errorsOf;
using test::filesOf;
using test::ShaderFolder;
namespace fs = std::filesystem;

std::string firstError(const CompiledShader& shader) {
    return shader.ok() ? "" : describe(shader.errors.front());
}

std::string constant(const std::string& value) {
    return "float f() { return " + value + "; }\n";
}

TEST(CompileInclude, NearestFolderGoesFirst) {
    const ShaderFolder folder;
    const std::string use = "#include \"f.glsl\"\n";
    folder.writeShader("entry/e.comp", "#include \"inner/g.glsl\"\nvoid main() { x = f(); }\n");
    folder.write("entry/inner/g.glsl", use);
    ShaderRequest request{folder.path / "entry/e.comp", {folder.path / "first", folder.path / "second"}, {}};

    // From the last place in the order of the search to the first.
    std::vector<std::vector<std::uint32_t>> results;
    for (const char* place : {"second", "first", "entry", "entry/inner"}) {
        folder.write(std::string(place) + "/f.glsl", constant(std::to_string(results.size()) + ".25"));
        const CompiledShader shader = compileShader(request);
        EXPECT_TRUE(shader.ok()) << place << "\n" << errorsOf(shader);
        EXPECT_EQ(std::count(results.begin(), results.end(), shader.words), 0) << place;
        results.push_back(shader.words);
        // Each of these would be taken instead, if it were there.
        const std::vector<std::string> files = filesOf(shader, folder.path);
        EXPECT_EQ(
            std::count_if(files.begin(), files.end(), [](const auto& name) { return name.back() == '?'; }),
            4 - static_cast<std::ptrdiff_t>(results.size()));
    }
}

TEST(CompileInclude, MissingOnesSayWhereTheyAreNot) {
    const ShaderFolder folder;
    folder.writeShader("sub/e.comp", "\n#include \"a/b.glsl\"\nvoid main() {}\n");
    const CompiledShader shader = folder.compile("sub/e.comp");
    EXPECT_EQ(firstError(shader),
              "sub/e.comp:6: cannot include \"a/b.glsl\": there is no \"sub/a/b.glsl\", \"a/b.glsl\"");
    EXPECT_EQ(shader.errors.size(), 1U);
    EXPECT_EQ(filesOf(shader, folder.path),
              (std::vector<std::string>{"a/b.glsl?", "sub/a/b.glsl?", "sub/e.comp"}));
}

TEST(CompileInclude, OtherFormsAreRefused) {
    const ShaderFolder folder;
    folder.write("f.glsl", constant("1.0"));
    folder.writeShader("e.comp", "#include <f.glsl>\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("e.comp")),
              "e.comp:5: #include <...> is not known here, write #include \"...\"");
    folder.write("none.glsl", "#include \"none at all.glsl\"\n");
    folder.writeShader("e.comp", "#include \"none.glsl\"\n#include <f.glsl>\nvoid main() {}\n");
    EXPECT_NE(errorsOf(folder.compile("e.comp")).find("e.comp:6: #include <...>"), std::string::npos)
        << errorsOf(folder.compile("e.comp"));
    folder.writeShader("e.comp", "#include \"\"\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("e.comp")), "e.comp:5: cannot include \"\": that is no file name");
    folder.writeShader("e.comp", "#include \"f.gl");
    EXPECT_EQ(firstError(folder.compile("e.comp")), "e.comp:5: '#include' : missing closing quotation mark");
    folder.write("half.glsl", "\n#include \"f.gl");
    folder.writeShader("e.comp", "#include \"half.glsl\"\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("e.comp")),
              "half.glsl:2: '#include' : missing closing quotation mark");
    folder.write("half.glsl", "\n#include \"f.gl\n\n// a \"word\"\n");
    EXPECT_EQ(firstError(folder.compile("e.comp")),
              "half.glsl:2: '#include' : missing closing quotation mark");
    folder.writeShader("e.comp", "#include \"f.glsl\" x\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("e.comp")),
              "e.comp:5: '#include' : extra content after header name: f.glsl");
}

TEST(CompileInclude, CyclesNameTheirChain) {
    const ShaderFolder folder;
    folder.write("b.glsl", constant("1.0") + "#include \"sub/c.glsl\"\n");
    folder.write("sub/c.glsl", "\n#include \"../b.glsl\"\n");
    folder.writeShader("e.comp", "#include \"b.glsl\"\nvoid main() {}\n");
    const CompiledShader shader = folder.compile("e.comp");
    EXPECT_EQ(firstError(shader), "sub/c.glsl:2: include cycle: b.glsl includes sub/c.glsl includes b.glsl");
    EXPECT_EQ(filesOf(shader, folder.path), (std::vector<std::string>{"b.glsl", "e.comp", "sub/c.glsl"}));
    folder.writeShader("self.comp", "#include \"self.comp\"\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("self.comp")),
              "self.comp:5: include cycle: self.comp includes self.comp");
}

TEST(CompileInclude, GuardsEndCycles) {
    const ShaderFolder folder;
    folder.write("a.glsl",
                 "// words\n#ifndef A\n#define A\n#include \"b.glsl\"\n" + constant("g()") + "#endif\n");
    folder.write("b.glsl",
                 "#if !defined(B)\n#define B 1\n#include \"a.glsl\"\nfloat g() { return 1.0; }\n#endif\n");
    folder.writeShader(
        "e.comp",
        "#include \"a.glsl\"\n#include \"b.glsl\"\n#include \"a.glsl\"\nvoid main() { x = f(); }\n");
    EXPECT_TRUE(folder.compile("e.comp").ok()) << errorsOf(folder.compile("e.comp"));
}

TEST(CompileInclude, GuardsThatDoNotGuardAreCycles) {
    const ShaderFolder folder;
    folder.write("a.glsl", "#ifndef A\n#define A\n#undef A\n#include \"b.glsl\"\n#endif\n");
    folder.write("b.glsl",
                 "#ifndef B\n#define B\n#undef B\n#include \"a.glsl\"\n#include \"a.glsl\"\n#endif\n");
    folder.writeShader("e.comp", "#include \"a.glsl\"\n#include \"a.glsl\"\nvoid main() {}\n");
    const std::string error = firstError(folder.compile("e.comp"));
    EXPECT_TRUE(error.ends_with("include cycle: a.glsl includes b.glsl includes a.glsl") ||
                error.ends_with("include cycle: b.glsl includes a.glsl includes b.glsl"))
        << error;
}

// Whatever a compiler asks for after that, it comes to an end.
TEST(CompileInclude, NothingIsFoundAfterACycle) {
    const ShaderFolder folder;
    const fs::path entry = folder.write("e.comp", "words");
    folder.write("f.glsl", constant("1.0"));
    IncludeSearch search(entry, {folder.path});
    EXPECT_NE(search.find("f.glsl", 1).source, nullptr);
    const std::string refusal = search.find("e.comp", 2).refusal;
    EXPECT_EQ(refusal, "include cycle: e.comp includes f.glsl includes e.comp");
    EXPECT_EQ(search.find("f.glsl", 1).refusal, refusal);
    EXPECT_EQ(search.find("f.glsl", 1).source, nullptr);
}

TEST(CompileInclude, DepthAndAmountAreLimited) {
    const ShaderFolder folder;
    for (int i = 0; i < 70; ++i) {
        folder.write(std::to_string(i) + ".glsl", "#include \"" + std::to_string(i + 1) + ".glsl\"\n");
    }
    folder.write("70.glsl", "");
    folder.writeShader("deep.comp", "#include \"0.glsl\"\nvoid main() {}\n");
    EXPECT_EQ(firstError(folder.compile("deep.comp")),
              "62.glsl:1: cannot include \"63.glsl\": it lies 64 includes deep");
    folder.writeShader("less.comp", "#include \"8.glsl\"\nvoid main() {}\n");
    EXPECT_TRUE(folder.compile("less.comp").ok()) << errorsOf(folder.compile("less.comp"));

    // Without a limit 2^40 includes.
    for (int i = 0; i < 40; ++i) {
        const std::string line = "#include \"d" + std::to_string(i + 1) + ".glsl\"\n";
        folder.write("d" + std::to_string(i) + ".glsl", line + line);
    }
    folder.write("d40.glsl", std::string(100, ' '));
    folder.writeShader("double.comp", "#include \"d0.glsl\"\nvoid main() {}\n");
    const std::string error = firstError(folder.compile("double.comp"));
    EXPECT_TRUE(error.ends_with("all together would be more than 1048576 bytes")) << error;
}

TEST(CompileInclude, OnlyFromTheShaderFolders) {
    const ShaderFolder folder;
    folder.write("outside.glsl", constant("1.0"));
    folder.write("root/inside.glsl", constant("2.0"));
    folder.write("rooted.glsl", constant("3.0"));  // its path begins as the root's does
    ShaderRequest request{folder.path / "root/sub/e.comp", {folder.path / "root"}, {}};
    const auto include = [&](const std::string& name) {
        folder.writeShader("root/sub/e.comp", "#include \"" + name + "\"\nvoid main() { x = f(); }\n");
        return compileShader(request);
    };
    EXPECT_TRUE(include("../inside.glsl").ok());
    EXPECT_TRUE(include("../sub/../inside.glsl").ok());
    for (const std::string& name : std::vector<std::string>{
             "../../outside.glsl", "..\\..\\outside.glsl", "../../../../../../../../../../etc/passwd",
             "../../rooted.glsl", (folder.path / "outside.glsl").string(),
             (folder.path / "root/inside.glsl").string()}) {
        const CompiledShader shader = include(name);
        EXPECT_TRUE(firstError(shader).ends_with("\": it leaves the shader folders")) << firstError(shader);
        EXPECT_TRUE(firstError(shader).starts_with("sub/e.comp:5: cannot include \"")) << firstError(shader);
        EXPECT_EQ(filesOf(shader, folder.path), std::vector<std::string>{"root/sub/e.comp"}) << name;
    }
}

TEST(CompileInclude, LinksMayNotLeadOutside) {
    const ShaderFolder folder;
    folder.write("out/f.glsl", constant("1.0"));
    folder.write("root/real/f.glsl", constant("2.0"));
    fs::create_symlink("../out/f.glsl", folder.path / "root/file.glsl");
    fs::create_directory_symlink("../out", folder.path / "root/folder");
    fs::create_directory_symlink("real", folder.path / "root/link");
    fs::create_symlink("loop.glsl", folder.path / "root/loop.glsl");
    fs::create_symlink("nowhere.glsl", folder.path / "root/dangling.glsl");
    fs::create_directory_symlink("root", folder.path / "link_to_root");
    const auto include = [&](const std::string& name, const std::string& root) {
        folder.writeShader("root/e.comp", "#include \"" + name + "\"\nvoid main() { x = f(); }\n");
        return compileShader({folder.path / root / "e.comp", {folder.path / root}, {}});
    };
    EXPECT_EQ(firstError(include("file.glsl", "root")),
              "e.comp:5: cannot include \"file.glsl\": file.glsl is a link that leaves the shader folders");
    EXPECT_EQ(
        firstError(include("folder/f.glsl", "root")),
        "e.comp:5: cannot include \"folder/f.glsl\": folder/f.glsl is a link that leaves the shader folders");
    EXPECT_EQ(firstError(include("loop.glsl", "root")),
              "e.comp:5: cannot include \"loop.glsl\": loop.glsl: too many levels of symbolic links");
    EXPECT_EQ(firstError(include("dangling.glsl", "root")),
              "e.comp:5: cannot include \"dangling.glsl\": there is no \"dangling.glsl\"");
    EXPECT_TRUE(include("link/f.glsl", "root").ok());
    EXPECT_TRUE(include("real/f.glsl", "link_to_root").ok())
        << errorsOf(include("real/f.glsl", "link_to_root"));
}

}  // namespace
}  // namespace raytorus::compile
