// SPDX-License-Identifier: MIT
// Shaders and scenes that are edited while the window shows them.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/file.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowReload : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        std::filesystem::copy(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "shaders", folder / "shaders",
                              std::filesystem::copy_options::recursive);
    }

    [[nodiscard]] std::string read(const std::string& file) const { return readTextFile(folder / file); }

    // As careful editors do: another file takes the name.
    void replace(const std::string& file, const std::string& text) const {
        writeFile(folder / file, std::as_bytes(std::span(text)));
    }

    // In place, as careless ones do.
    void overwrite(const std::string& file, const std::string& text) const {
        std::ofstream(folder / file, std::ios::trunc) << text;
    }

    // Puts `to` in the place of `from`, which the file has once, and returns what it held before.
    std::string edit(const std::string& file, const std::string& from, const std::string& to) const {
        const std::string before = read(file);
        const std::size_t at = before.find(from);
        EXPECT_NE(at, std::string::npos);
        EXPECT_EQ(before.find(from, at + 1), std::string::npos);
        std::string after = before;
        after.replace(at, from.size(), to);
        replace(file, after);
        return before;
    }

    // The line, from 1, in which `text` stands first.
    [[nodiscard]] int lineOf(const std::string& file, const std::string& text) const {
        const std::string whole = read(file);
        return 1 + static_cast<int>(std::count(
                       whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.find(text)), '\n'));
    }

    std::string awaitError() { return await("shader-error")["text"]; }

    void awaitPicture() {
        await("shaders");
        await("settled");
    }

    // Without waiting for a picture.
    void openWindow(const Arguments& arguments) {
        start(arguments);
        await("open");
        window = display().window();
        hand({"windowfocus", "--sync", std::to_string(window)});
    }

    void openEdited() {
        openWindow({scene("ring"), "--size", "64x48", "--edit", "shaders", "--spp", "1", "--no-panel"});
        awaitPicture();
    }
};

constexpr const char* sky = "precise float height = 0.5 + 0.5 * direction.z;";
constexpr const char* darkerSky = "precise float height = 0.25 + 0.25 * direction.z;";

TEST_F(WindowReload, KeepsTheLastGoodPictureWhileAShaderIsBroken) {
    openEdited();
    const image::Image first = screenshot("e");
    const int line = lineOf("shaders/torus/march.glsl", "void torus_step(");
    const std::string good = edit("shaders/torus/march.glsl", "void torus_step(", "floating torus_step(");
    const std::string place = "torus/march.glsl:" + std::to_string(line) + ": ";
    EXPECT_EQ(awaitError().substr(0, place.size()), place);
    EXPECT_TRUE(sameBits(first, screenshot("e")));
    replace("shaders/torus/march.glsl", good);
    await("shaders");
    EXPECT_TRUE(sameBits(first, screenshot("e")));
    close();
}

// Each macro is twice the one before: 2^37 words, which once took 24 GB and the machine with them.
TEST_F(WindowReload, AShaderThatExhaustsTheCompiler) {
    openEdited();
    std::string macros = "#define M0 1.0\n";
    for (int i = 1; i <= 37; ++i) {
        macros += fmt::format("#define M{0} M{1} + M{1}\n", i, i - 1);
    }
    const std::string good = read("shaders/shade.glsl");
    replace("shaders/shade.glsl", macros + good + "float endless() { return M37; }\n");
    EXPECT_EQ(awaitError(), "scene.frag: the compilation takes more than 2 GiB of memory");
    replace("shaders/shade.glsl", good);
    awaitPicture();
    close();
}

TEST_F(WindowReload, ShowsWhatWasEdited) {
    openEdited();
    const image::Image first = screenshot("e");
    const std::string good = edit("shaders/shade.glsl", sky, darkerSky);
    awaitPicture();
    EXPECT_FALSE(sameBits(first, screenshot("e")));
    replace("shaders/shade.glsl", good);
    awaitPicture();
    EXPECT_TRUE(sameBits(first, screenshot("e")));
    close();
}

TEST_F(WindowReload, SurvivesHalfWrittenAndDeletedFiles) {
    openEdited();
    const image::Image first = screenshot("e");
    const std::string good = read("shaders/shade.glsl");
    overwrite("shaders/shade.glsl", good.substr(0, good.size() / 2));
    EXPECT_NE(awaitError().find("shade.glsl"), std::string::npos);
    overwrite("shaders/shade.glsl", good);
    await("shaders");
    std::filesystem::remove(folder / "shaders/shade.glsl");
    EXPECT_NE(awaitError().find("shade.glsl"), std::string::npos);
    overwrite("shaders/shade.glsl", good);
    await("shaders");
    // The whole folder, as when a branch is checked out.
    std::filesystem::rename(folder / "shaders", folder / "elsewhere");
    EXPECT_NE(awaitError().find("scene.frag"), std::string::npos);
    std::filesystem::rename(folder / "elsewhere", folder / "shaders");
    await("shaders");
    EXPECT_TRUE(sameBits(first, screenshot("e")));
    close();
}

TEST_F(WindowReload, RefusesIncludesThatLeadOutAndCycles) {
    openEdited();
    overwrite("secret.glsl", "float secret() { return 1.0; }\n");
    const std::string good = edit("shaders/shade.glsl", "#include \"scene.glsl\"",
                                  "#include \"scene.glsl\"\n#include \"../secret.glsl\"");
    EXPECT_NE(awaitError().find("../secret.glsl"), std::string::npos);
    replace("shaders/shade.glsl", good);
    await("shaders");
    overwrite("shaders/loop.glsl", "#include \"loop.glsl\"\n");
    edit("shaders/shade.glsl", "#include \"scene.glsl\"", "#include \"scene.glsl\"\n#include \"loop.glsl\"");
    EXPECT_NE(awaitError().find("loop.glsl"), std::string::npos);
    close();
}

TEST_F(WindowReload, BeginsWithTheLibraryWhereTheFirstLoadFails) {
    const std::string good = edit("shaders/shade.glsl", sky, "nonsense");
    openWindow({scene("ring"), "--size", "64x48", "--edit", "shaders", "--spp", "1", "--no-panel"});
    EXPECT_NE(awaitError().find("shade.glsl"), std::string::npos);
    EXPECT_TRUE(sameBits(rendered({scene("ring"), "--size", "64x48"}), screenshot("e")));
    replace("shaders/shade.glsl", good);
    await("shaders");
    EXPECT_TRUE(sameBits(rendered({scene("ring"), "--size", "64x48"}), screenshot("e")));
    close();
}

TEST_F(WindowReload, EndsAScriptWithTheError) {
    edit("shaders/shade.glsl", sky, "nonsense");
    const ProgramResult result =
        runViewer({scene("ring"), "--size", "64x48", "--edit", "shaders", "--screenshot", "picture.png"});
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::Shader));
    EXPECT_EQ(result.err.substr(0, 26), "raytorus-view: shade.glsl:") << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "picture.png"));
}

TEST_F(WindowReload, FollowsTheSceneFile) {
    overwrite("own.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    open({"own.json", "--size", "64x48", "--spp", "1", "--no-panel"});
    replace("own.json", R"({"tori": [{"majorRadius": 1, "minorRadius": -0.25}]})");
    EXPECT_NE(std::string(await("message")["text"]).find("/tori/0/minorRadius"), std::string::npos);
    replace("own.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.5}]})");
    await("scene");
    await("settled");
    EXPECT_TRUE(sameBits(rendered({"own.json", "--size", "64x48"}), screenshot("e")));
    close();
}

}  // namespace
}  // namespace raytorus::test
