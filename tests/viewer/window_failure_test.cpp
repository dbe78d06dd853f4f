// SPDX-License-Identifier: MIT
// What cannot be: the exit code and the one sentence of each failure, and nothing left behind.
#include <algorithm>

#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowFailure : public WindowTest {
protected:
    // One sentence with the words on standard error, nothing on standard output, no file.
    void expectFailure(const Arguments& arguments, ExitCode code, const std::vector<std::string>& words,
                       const Environment& environment = {}) const {
        SCOPED_TRACE(testing::PrintToString(arguments));
        const std::vector<std::string> before = namesIn(folder);
        const ProgramResult result = runViewer(arguments, environment);
        EXPECT_EQ(result.exitCode, static_cast<int>(code)) << testing::PrintToString(result);
        EXPECT_EQ(result.out, "");
        EXPECT_TRUE(result.err.starts_with("raytorus-view: ")) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        for (const std::string& word : words) {
            EXPECT_NE(result.err.find(word), std::string::npos)
                << "\"" << word << "\" is not in: " << result.err;
        }
        EXPECT_EQ(namesIn(folder), before);
    }

    const std::string ring = scene("ring");
};

TEST_F(WindowFailure, OfTheCommandLine) {
    const std::vector<std::pair<Arguments, std::vector<std::string>>> cases = {
        {{}, {"a scene is required"}},
        {{ring, "--view", "shady"}, {"no view \"shady\"", "--list-views"}},
        {{ring, "--method", "newton"}, {"\"newton\""}},
        {{ring, "--route", "ray"}, {"--route", "fragment", "compute", "\"ray\""}},
        {{ring, "--spp", "3"}, {"--spp", "square", "\"3\""}},
        {{ring, "--spp", "289"}, {"--spp", "256", "\"289\""}},
        {{ring, "--size", "0x5"}, {"--size", "0x5"}},
        {{ring, "--wipe", "closed-form@2"}, {"--wipe", "\"closed-form@2\""}},
        {{ring, "--wipe", "nothing@0.5"}, {"\"nothing\""}},
        {{ring, "--pick", "1.5,2"}, {"--pick", "\"1.5,2\""}},
        {{ring, "--pick", "-1,2"}, {"--pick", "\"-1,2\""}},
        {{ring, "--screenshot", "a.jpg"}, {"--screenshot", ".png or .exr", "a.jpg"}},
        {{ring, "--window-screenshot", "a.exr"}, {"--window-screenshot", ".png", "a.exr"}},
        {{ring, "--frames", "0"}, {"--frames"}},
        {{ring, "--time", "1e9"}, {"--time"}},
        {{ring, "--nonsense"}, {"--nonsense", "--help"}},
        {{ring, "--timeout", "0"}, {"--timeout"}},
    };
    for (const auto& [arguments, words] : cases) {
        expectFailure(arguments, ExitCode::Usage, words);
    }
}

TEST_F(WindowFailure, OfFilesAndScenes) {
    expectFailure({"missing.json"}, ExitCode::File, {"missing.json"});
    expectFailure({folder.string()}, ExitCode::File, {folder.string()});
    writeText(folder / "empty.json", R"({"tori": []})");
    expectFailure({"empty.json"}, ExitCode::Scene, {"empty.json", "tori"});
    writeText(folder / "broken.json", R"({"tori": [)");
    expectFailure({"broken.json"}, ExitCode::Scene, {"broken.json"});
    expectFailure({ring, "--golden", "missing.exr"}, ExitCode::File, {"missing.exr"});
    expectFailure({ring, "--size", "48x32", "--screenshot", "missing/picture.png"}, ExitCode::File,
                  {"missing"});
    expectFailure({ring, "--size", "48x32", "--window-screenshot", "missing/window.png"}, ExitCode::File,
                  {"missing"});
    expectFailure({ring, "--size", "48x32", "--screenshot", "p.png", "--pick", "48,0"}, ExitCode::Usage,
                  {"(48, 0)", "48 x 32"});
}

TEST_F(WindowFailure, OfDisplaysAndDevices) {
    expectFailure({ring}, ExitCode::NoDevice, {"no window can be opened", "DISPLAY", "xvfb-run"},
                  {{"DISPLAY", ""}});
    expectFailure({ring}, ExitCode::NoDevice, {"no window can be opened", "DISPLAY"},
                  {{"DISPLAY", ":99999"}});
    const ProgramResult other = runViewer({ring, "--device", "abacus"});
    EXPECT_EQ(other.exitCode, static_cast<int>(ExitCode::NoDevice)) << testing::PrintToString(other);
    EXPECT_TRUE(
        other.err.starts_with("raytorus-view: no suitable Vulkan device matches 'abacus'; there are:\n"))
        << other.err;
    expectFailure(
        {ring}, ExitCode::NoDevice, {"Vulkan driver"},
        {{"VK_DRIVER_FILES", "/there/is/no/driver.json"}, {"VK_ICD_FILENAMES", "/there/is/no/driver.json"}});
    expectFailure({ring, "--size", "48x32", "--frames", "3", "--timeout", "1e-6"}, ExitCode::DeviceLost,
                  {"did not finish", "1e-06"});
}

TEST_F(WindowFailure, OfAKeyIsToldAndTheWindowStays) {
    std::filesystem::create_directory(folder / "locked");
    writeText(folder / "scene.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}]})");
    open({"scene.json", "--size", "48x32", "--no-panel", "--spp", "1"});
    writeText(folder / "scene.json", R"({"tori": [{"majorRadius": 1, "minorRadius": -1}]})");
    press({"F5"});
    const std::string told = await("message")["text"];
    EXPECT_NE(told.find("minorRadius"), std::string::npos) << told;
    writeText(folder / "scene.json", R"({"tori": [{"majorRadius": 1, "minorRadius": 0.5}]})");
    press({"F5"});
    EXPECT_EQ(await("scene")["file"], "scene.json");
    await("settled");
    close();
}

TEST_F(WindowFailure, HelpAndListsNeedNoDisplay) {
    for (const char* option : {"--help", "--version", "--list-views", "--list-keys"}) {
        const ProgramResult result =
            runViewer({option}, {{"DISPLAY", ""}, {"VK_DRIVER_FILES", "/no/driver.json"}});
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out, "");
    }
}

TEST_F(WindowFailure, OfTheDisplay) {
    auto own = std::make_unique<Display>(folder / "server.txt");
    start({ring}, {{"DISPLAY", own->name()}});
    await("settled");
    own.reset();
    const std::string words = expectEnd(ExitCode::DeviceLost);
    EXPECT_EQ(words, "raytorus-view: the connection to the display has broken\n");
}

}  // namespace
}  // namespace raytorus::test
