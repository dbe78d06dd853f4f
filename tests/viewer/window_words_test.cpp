// SPDX-License-Identifier: MIT
// Words from files in a window: in its title, in the panel, in the command that is copied.
#include <fmt/format.h>

#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowWords : public WindowTest {};

TEST_F(WindowWords, TheTitleHoldsNoControlCharacters) {
    const std::string name = "a\x1b[31m\u009b\xff.json";
    std::filesystem::copy_file(scene("ring"), folder / name);
    open({name, "--size", "160x100"});
    EXPECT_EQ(display().hand({"getwindowname", std::to_string(window)}),
              "a\\u001b[31m\\u009b\\xff.json - raytorus\n");
    close();
}

// It is shown on a slider, which takes a format for its number: the program crashed.
TEST_F(WindowWords, AMaterialsNameIsNoFormat) {
    writeText(
        folder / "scene.json",
        R"({"materials": {"%s%s%s%n%n%n": {}, "100 %": {}}, "tori": [{"majorRadius": 1, "minorRadius": 0.25,
                  "material": "%s%s%s%n%n%n"}]})");
    open({"scene.json", "--size", "640x900"});
    press({"Tab", "Tab"});
    close();
}

TEST_F(WindowWords, TheCommandHasTheDeviceThatWasGiven) {
    open({scene("ring"), "--size", "160x100", "--device", "llvmpipe (LLVM", "--timeout", "60"});
    press({"p"});
    const Json picked = await("picked");
    const std::string command = picked["command"];
    EXPECT_TRUE(
        command.starts_with("raytorus explain --device 'llvmpipe (LLVM' --validate --timeout 60 --replay \""))
        << command;
    const std::string programs = std::filesystem::path(RAYTORUS_PROGRAM).parent_path().string();
    const ProgramResult told =
        runProgram("/bin/sh", {"-c", command}, {folder, {{"PATH", programs + ":/usr/bin:/bin"}}});
    EXPECT_EQ(told.exitCode, 0) << told.err;
    EXPECT_TRUE(picked["text"].get<std::string>().ends_with("\n\n" + told.out)) << told.out;
    close();
}

}  // namespace
}  // namespace raytorus::test
