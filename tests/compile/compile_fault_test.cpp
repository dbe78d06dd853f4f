// SPDX-License-Identifier: MIT
// Files in every state that an editor or an accident leaves them in: an error with its sentence, never a
// crash.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "compile/compile_shader.hpp"
#include "shader_folder.hpp"
#include "support/process_limits.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using test::errorsOf;
using test::ShaderFolder;
namespace fs = std::filesystem;

struct Unreadable {
    const char* name;
    const char* problem;
};

void PrintTo(const Unreadable& state, std::ostream* out) {
    *out << state.name;
}

// What no shader can be: as an entry, and as an include of one.
class CompileFaults : public testing::TestWithParam<Unreadable> {
public:
    // In place of the file.
    void make(const fs::path& path) const {
        const std::string name = GetParam().name;
        fs::remove_all(path);
        if (name == "Folder") {
            fs::create_directory(path);
        } else if (name == "Pipe") {
            ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
            fs::permissions(path, fs::perms::all);
        } else if (name == "Device") {
            fs::create_symlink("/dev/zero", path);
        } else if (name == "Forbidden") {
            test::writeText(path, "void main() {}\n");
            fs::permissions(path, fs::perms::none);
        } else if (name == "Large") {
            test::writeText(path, std::string(maxSourceBytes + 1, '\n'));
        } else if (name == "Binary") {
            test::writeText(path, std::string("void\0main() {}\n", 15));
        } else if (name == "ByteOrderMark") {
            test::writeText(path, "\xef\xbb\xbf#version 460\n");
        }
    }
};

TEST_P(CompileFaults, Entry) {
    const ShaderFolder folder;
    make(folder.path / "e.comp");
    const test::WithoutPrivileges guard;
    const CompiledShader shader = folder.compile("e.comp");
    EXPECT_EQ(errorsOf(shader), std::string("e.comp: cannot read this shader: ") + GetParam().problem + "\n");
    ASSERT_EQ(shader.files.size(), 1U);
    EXPECT_EQ(shader.files[0].path, folder.path / "e.comp");
    // Of a file that is too large, its size and times follow.
    EXPECT_TRUE(shader.files[0].fingerprint.starts_with(GetParam().problem)) << shader.files[0].fingerprint;
}

TEST_P(CompileFaults, Include) {
    const ShaderFolder folder;
    folder.writeShader("e.comp", "\n#include \"part.glsl\"\nvoid main() { x = 1.0; }\n");
    make(folder.path / "part.glsl");
    const test::WithoutPrivileges guard;
    const CompiledShader shader = folder.compile("e.comp");
    ASSERT_EQ(shader.errors.size(), 1U) << errorsOf(shader);
    const std::string expected = std::string(GetParam().name) == "Missing" ? "there is no \"part.glsl\""
                                 : std::string(GetParam().name) == "Device"
                                     ? "part.glsl is a link that leaves the shader folders"
                                     : std::string("part.glsl: ") + GetParam().problem;
    EXPECT_EQ(errorsOf(shader), "e.comp:6: cannot include \"part.glsl\": " + expected + "\n");
    ASSERT_EQ(shader.files.size(), 2U);
    EXPECT_EQ(shader.files[1].path, folder.path / "part.glsl");
    EXPECT_TRUE(shader.files[1].fingerprint.starts_with(GetParam().problem)) << shader.files[1].fingerprint;
}

INSTANTIATE_TEST_SUITE_P(
    All, CompileFaults,
    testing::Values(
        Unreadable{"Missing", "there is no such file"}, Unreadable{"Folder", "it is a directory"},
        Unreadable{"Pipe", "it is not a regular file"}, Unreadable{"Device", "it is not a regular file"},
        Unreadable{"Forbidden", "permission denied"}, Unreadable{"Large", "it has more than 1048576 bytes"},
        Unreadable{"Binary", "it is no text, byte 4 is zero"},
        Unreadable{"ByteOrderMark", "it begins with a byte order mark, which GLSL does not know"}),
    [](const auto& test) { return test.param.name; });

TEST(CompileFault, EmptyEntryIsRefusedAndEmptyIncludeIsNot) {
    const ShaderFolder folder;
    folder.write("e.comp", "");
    EXPECT_EQ(errorsOf(folder.compile("e.comp")), "e.comp: cannot read this shader: it is empty\n");
    folder.write("part.glsl", "");
    folder.writeShader("e.comp",
                       "#include \"part.glsl\"\n#include \"part.glsl\"\nvoid main() { x = 1.0; }\n");
    EXPECT_TRUE(folder.compile("e.comp").ok()) << errorsOf(folder.compile("e.comp"));
    folder.write("blank.comp", "\n\n  \n");
    EXPECT_FALSE(folder.compile("blank.comp").ok());
}

TEST(CompileFault, PathsOfAnyLengthOrNone) {
    EXPECT_FALSE(compileShader({"", {""}, {}}).ok());
    EXPECT_FALSE(compileShader({std::string(100'000, 'a') + ".comp", {std::string(100'000, 'b')}, {}}).ok());
    const ShaderFolder folder;
    folder.writeShader("e.comp", "#include \"" + std::string(300, 'c') + "\"\nvoid main() {}\n");
    EXPECT_NE(errorsOf(folder.compile("e.comp")).find(": file name too long"), std::string::npos);
    folder.writeShader("e.comp", "#include \"" + std::string(300'000, 'c') + "\"\nvoid main() {}\n");
    EXPECT_FALSE(folder.compile("e.comp").ok());
}

TEST(CompileFault, WorkingFolderThatIsGone) {
    const ShaderFolder folder;
    folder.writeShader("e.comp", "void main() {}\n");
    const fs::path before = fs::current_path();
    fs::create_directory(folder.path / "gone");
    fs::current_path(folder.path / "gone");
    fs::remove(folder.path / "gone");
    EXPECT_TRUE(folder.compile("e.comp").ok());
    EXPECT_FALSE(compileShader({"e.comp", {"."}, {}}).ok());
    fs::current_path(before);
}

// Each overflows a stack of 8 MiB in glslang 12.0.
TEST(CompileFault, ExpressionsAsLongAsAFileMayBe) {
    const auto joined = [](const std::string& operand, const std::string& between, std::size_t size) {
        std::string text = operand;
        while (text.size() < size) {
            text += between + operand;
        }
        return text;
    };
    constexpr std::size_t size = maxSourceBytes - 1000;
    const ShaderFolder folder;
    folder.writeShader("sum.comp", "void main() { x = " + joined("x", "+", size) + "; }\n");
    EXPECT_TRUE(folder.compile("sum.comp").ok());
    folder.writeShader("comma.comp", "void main() { " + joined("x", ",", size) + "; }\n");
    EXPECT_TRUE(folder.compile("comma.comp").ok());
    folder.writeShader("condition.comp", "#if " + std::string(size, '!') + "1\n#endif\nvoid main() {}\n");
    EXPECT_TRUE(folder.compile("condition.comp").ok());
    // The parser has a limit of its own for what nests.
    folder.writeShader("nested.comp", "void main() { x = " + std::string(size / 2, '(') + "x" +
                                          std::string(size / 2, ')') + "; }\n");
    EXPECT_FALSE(folder.compile("nested.comp").ok());
}

}  // namespace
}  // namespace raytorus::compile
