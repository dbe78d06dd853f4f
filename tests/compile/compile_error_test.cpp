// SPDX-License-Identifier: MIT
// Errors name the file and the line that people have to look at, through includes and macros.
#include <gtest/gtest.h>

#include "compile/compile_shader.hpp"
#include "shader_folder.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using test::errorsOf;
using test::ShaderFolder;

// One error, and this one.
void expectError(const ShaderFolder& folder, const std::string& entry, const std::string& expected) {
    const CompiledShader shader = folder.compile(entry);
    ASSERT_FALSE(shader.ok());
    EXPECT_EQ(describe(shader.errors.front()), expected) << errorsOf(shader);
    EXPECT_TRUE(shader.words.empty());
    EXPECT_FALSE(shader.files.empty());
    for (const CompileError& error : shader.errors) {
        EXPECT_EQ(error.text.find('\n'), std::string::npos) << error.text;
        EXPECT_EQ(error.text.find('@'), std::string::npos) << error.text;
        EXPECT_EQ(error.file.find('@'), std::string::npos) << error.file;
    }
}

constexpr const char* missing = "'missing' : undeclared identifier";

struct CompileErrors : testing::Test {
    CompileErrors() {
        folder.write("ok.glsl", "float ok() { return 1.0; }\n");
        folder.write("no_line_end.glsl", "\n\n\nfloat okay() { return 1.0; }");
        folder.write("empty.glsl", "");
        folder.write("bad.glsl", "\n\nfloat bad() {\n    return missing;\n}\n");
        folder.write("sub/second.glsl", "\n#include \"../bad.glsl\"\n");
        folder.write("first.glsl", "#include \"ok.glsl\"\n#include \"sub/second.glsl\"\n");
    }
    ShaderFolder folder;
};

TEST_F(CompileErrors, InTheEntry) {
    folder.writeShader("e.comp", "\nvoid main() {\n    x = missing;\n}\n");
    expectError(folder, "e.comp", std::string("e.comp:7: ") + missing);
    EXPECT_EQ(folder.compile("e.comp").errors.size(), 1U) << "what follows from it is noise";
}

TEST_F(CompileErrors, InAnIncludeOfTheFirstAndOfTheThirdLevel) {
    folder.writeShader("one.comp", "#include \"bad.glsl\"\nvoid main() { x = bad(); }\n");
    expectError(folder, "one.comp", std::string("bad.glsl:4: ") + missing);
    folder.writeShader("three.comp", "\n#include \"first.glsl\"\nvoid main() { x = bad(); }\n");
    expectError(folder, "three.comp", std::string("bad.glsl:4: ") + missing);
    folder.write("sub/bad.glsl", "float bad() { return missing; }\n");
    folder.write("sub/second.glsl", "#include \"bad.glsl\"\n");
    expectError(folder, "three.comp", std::string("sub/bad.glsl:1: ") + missing);
}

TEST_F(CompileErrors, AfterOtherIncludesHaveEnded) {
    folder.writeShader("e.comp",
                       "#include \"ok.glsl\"\n#include \"no_line_end.glsl\"\n#include \"empty.glsl\"\n"
                       "void main() {\n    x = missing;\n}\n");
    expectError(folder, "e.comp", std::string("e.comp:9: ") + missing);
    folder.write(
        "outer.glsl",
        "#include \"no_line_end.glsl\"\n#include \"ok.glsl\"\nfloat f() {\n    return missing;\n}\n");
    folder.writeShader("in.comp", "#include \"outer.glsl\"\nvoid main() { x = 1.0; }\n");
    expectError(folder, "in.comp", std::string("outer.glsl:4: ") + missing);
}

TEST_F(CompileErrors, InAMacrosExpansionAreWhereItIsUsed) {
    folder.write("macro.glsl", "\n#define TWICE(a) \\\n    ((a) + missing)\n");
    folder.writeShader("e.comp", "#include \"macro.glsl\"\n\nvoid main() {\n    x = TWICE(1.0);\n}\n");
    expectError(folder, "e.comp", std::string("e.comp:8: ") + missing);
}

TEST_F(CompileErrors, WithOtherLineEndsAndJoinedLines) {
    folder.write("crlf.comp", "#version 460\r\nvoid main() {\r\n    missing;\r\n}\r\n");
    expectError(folder, "crlf.comp", std::string("crlf.comp:3: ") + missing);
    folder.writeShader("joined.comp", "// a comment \\\n that goes on\nvoid main() {\n    x = missing;\n}\n");
    expectError(folder, "joined.comp", std::string("joined.comp:8: ") + missing);
    folder.writeShader("block.comp", "/* one\n two\n three */ void main() {\n    x = missing;\n}\n");
    expectError(folder, "block.comp", std::string("block.comp:8: ") + missing);
}

TEST_F(CompileErrors, UnterminatedCommentIsWhereItBegins) {
    const std::string text = "'comment' : End of input in comment";
    folder.writeShader("e.comp", "void main() {}\n\n/* never\nclosed\n");
    expectError(folder, "e.comp", "e.comp:7: " + text);
    folder.write("c.glsl", "float f() { return 1.0; }\n/* never\nclosed\n");
    folder.writeShader("in.comp", "#include \"c.glsl\"\nvoid main() { x = f(); }\n");
    expectError(folder, "in.comp", "c.glsl:2: " + text);
}

TEST_F(CompileErrors, UnterminatedConditionalIsWhereItBegins) {
    folder.writeShader("e.comp", "void main() {}\n#if 1\n#ifdef A\n#endif\n");
    expectError(folder, "e.comp", "e.comp:6: '#if' : missing #endif");
    folder.writeShader("last.comp", "void main() {}\n#if 0");
    expectError(folder, "last.comp", "last.comp:6: '#if' : missing #endif");
    folder.writeShader("in.comp", "#include \"ok.glsl\"\n#include \"c.glsl\"\nvoid main() { x = f(); }\n");
    for (const char* condition : {"ifdef GL_SPIRV", "if 0", "ifndef A", "ifdef GL_SPIRV // #endif"}) {
        folder.write("c.glsl", "float f() { return 1.0; }\n\n#" + std::string(condition) +
                                   "\n/* #endif */\nfloat g;\n");
        const std::string word = std::string(condition).substr(0, std::string(condition).find(' '));
        expectError(folder, "in.comp", "c.glsl:3: '#" + word + "' : missing #endif");
    }
    folder.write("c.glsl", "float f() { return 1.0; }\n#endif\n");
    expectError(folder, "in.comp", "c.glsl:2: '#endif' : mismatched statements");
}

TEST_F(CompileErrors, InLinking) {
    folder.writeShader("none.comp", "float f() { return 1.0; }\n");
    expectError(folder, "none.comp", "none.comp: Missing entry point: Each stage requires one entry point");
    folder.writeShader("body.comp", "float f();\nvoid main() { x = f(); }\n");
    expectError(folder, "body.comp", "body.comp: No function definition (body) found: f(");
    folder.writeShader(
        "again.comp",
        "float f();\nfloat g() { return f(); }\nfloat f() { return g(); }\nvoid main() { x = f(); }\n");
    expectError(folder, "again.comp", "again.comp: Recursion detected: f( calling g(");
}

TEST_F(CompileErrors, OfTheVersion) {
    folder.write("none.comp", "void main() {}\n");
    EXPECT_EQ(folder.compile("none.comp").errors.front().line, 1);
    folder.write("other.comp", "// words\n#version 999\nvoid main() {}\n");
    expectError(folder, "other.comp", "other.comp:2: version not supported");
    folder.write("old.comp", "// words\n\n#version 310\nvoid main() {}\n");
    EXPECT_EQ(folder.compile("old.comp").errors.front().line, 3) << errorsOf(folder.compile("old.comp"));
}

TEST_F(CompileErrors, OfTheShadersOwn) {
    folder.write("own.glsl", "\n#error This is: wrong.\n");
    folder.writeShader("e.comp", "#include \"own.glsl\"\nvoid main() {}\n");
    expectError(folder, "e.comp", "own.glsl:2: '#error' : This is : wrong");
}

TEST_F(CompileErrors, LineDirectivesAreBelieved) {
    folder.writeShader("e.comp", "#line 77 \"generated.txt\"\nvoid main() { x = missing; }\n");
    expectError(folder, "e.comp", std::string("generated.txt:77: ") + missing);
    folder.writeShader("number.comp", "#line 77\nvoid main() { x = missing; }\n");
    expectError(folder, "number.comp", std::string("number.comp:77: ") + missing);
}

TEST_F(CompileErrors, StrangeNamesAreNamed) {
    for (const char* name :
         {"with space.glsl", "a:12: b.glsl", "@0:1: x.glsl", "\xc3\xa4.glsl", "'x'.glsl"}) {
        folder.write(name, "\nfloat f() { return missing; }\n");
        folder.writeShader("e.comp", std::string("#include \"") + name + "\"\nvoid main() { x = f(); }\n");
        const CompiledShader shader = folder.compile("e.comp");
        ASSERT_FALSE(shader.ok());
        EXPECT_EQ(shader.errors.front().file, name);
        EXPECT_EQ(shader.errors.front().line, 2);
        EXPECT_EQ(shader.errors.front().text, missing);
    }
}

TEST_F(CompileErrors, BytesThatAreNoTextAreShownAsNumbers) {
    folder.writeShader("e.comp", "void main() { x = \xff\x01; }\n");
    const std::string text = errorsOf(folder.compile("e.comp"));
    EXPECT_TRUE(text.starts_with("e.comp:5: '\\x")) << text;
}

TEST_F(CompileErrors, WarningsAreNone) {
    folder.writeShader("e.comp", "#define a__b 1\nvoid main() { x = 1.0; }\n");
    EXPECT_TRUE(folder.compile("e.comp").ok());
    folder.writeShader("e.comp", "#define a__b 1\nvoid main() { x = missing; }\n");
    EXPECT_EQ(folder.compile("e.comp").errors.size(), 1U) << errorsOf(folder.compile("e.comp"));
}

}  // namespace
}  // namespace raytorus::compile
