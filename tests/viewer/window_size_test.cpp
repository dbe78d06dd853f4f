// SPDX-License-Identifier: MIT
// Windows that change their size, are minimised, uncovered and closed.
#include <fmt/format.h>

#include "image/image_io.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

class WindowSize : public WindowTest {};

TEST_F(WindowSize, MayChangeFasterThanPicturesAreDrawn) {
    open({scene("ring"), "--size", "200x150", "--spp", "1"});
    // In one go, and one by one.
    Arguments storm;
    for (int i = 0; i < 20; ++i) {
        const bool least = i % 7 == 3;
        storm.insert(storm.end(),
                     {"windowsize", std::to_string(window), least ? "1" : std::to_string(90 + 61 * i % 500),
                      least ? "1" : std::to_string(400 - 17 * i)});
    }
    hand(storm);
    const std::vector<std::pair<int, int>> sizes = {{1, 1},      {1, 300}, {640, 1}, {7, 5},
                                                    {1200, 900}, {33, 31}, {120, 80}};
    for (const auto& [width, height] : sizes) {
        resize(width, height);
        await("settled", [&, w = width, h = height](const Json& event) {
            return event["width"] == w && event["height"] == h;
        });
    }
    press({"Tab"});
    EXPECT_TRUE(sameBits(rendered({scene("ring"), "--size", "120x80"}), screenshot("e")));
    close();
}

TEST_F(WindowSize, OfNothingWaits) {
    open({scene("ring"), "--size", "96x64", "--no-panel", "--spp", "1"});
    // As a window manager does it.
    display().minimise(window);
    await("size", [](const Json& event) { return event["width"] == 0 && event["height"] == 0; });
    display().restore(window);
    await("size", [](const Json& event) { return event["width"] == 96 && event["height"] == 64; });
    hand({"windowfocus", "--sync", std::to_string(window)});
    EXPECT_TRUE(sameBits(rendered({scene("ring"), "--size", "96x64"}), screenshot("e")));

    // Unmapped without a word about it.
    hand({"windowunmap", "--sync", std::to_string(window), "windowmap", "--sync", std::to_string(window),
          "windowfocus", "--sync", std::to_string(window)});
    pressAndSettle({"Left"});
    resize(80, 60);
    await("settled", [](const Json& event) { return event["width"] == 80; });
    close();
}

TEST_F(WindowSize, GoesWithAClosedWindow) {
    open({scene("ring"), "--size", "96x64"});
    display().askToClose(window);
    expectEnd();

    // While pictures are drawn.
    start({scene("chain"), "--size", "320x200", "--spp", "256"});
    await("size");
    display().askToClose(display().window());
    expectEnd();

    // While it is minimised.
    open({scene("ring"), "--size", "96x64"});
    display().minimise(window);
    await("size", [](const Json& event) { return event["width"] == 0; });
    display().askToClose(window);
    expectEnd();

    // While the reference is asked in the background.
    open({scene("chain"), "--size", "320x200", "--spp", "1", "--view", "reference"});
    display().askToClose(window);
    expectEnd();
}

TEST_F(WindowSize, OfTheScreenAndBack) {
    open({scene("ring"), "--size", "96x64", "--no-panel", "--spp", "1"});
    press({"F11"});
    await("fullscreen");
    await("settled", [](const Json& event) { return event["width"] == 1280 && event["height"] == 1024; });
    press({"F11"});
    await("settled", [](const Json& event) { return event["width"] == 96 && event["height"] == 64; });
    close();
}

}  // namespace
}  // namespace raytorus::test
