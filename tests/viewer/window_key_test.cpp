// SPDX-License-Identifier: MIT
// Every key of the list that users see does something: it is pressed, and an event of what came of it is
// awaited.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "image/image_io.hpp"
#include "viewer/keys.hpp"
#include "window_test.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

// "Ctrl+S" and "PageUp" as xdotool calls them.
std::string keysymOf(const std::string& keys) {
    static const std::map<std::string, std::string> others = {
        {"=", "equal"},       {"-", "minus"},    {"[", "bracketleft"}, {"]", "bracketright"},
        {".", "period"},      {",", "comma"},    {"?", "shift+slash"}, {"PageUp", "Prior"},
        {"PageDown", "Next"}, {"Esc", "Escape"}, {"Space", "space"},   {"Backspace", "BackSpace"}};
    const std::size_t plus = keys.find('+');
    if (plus != std::string::npos && plus + 1 < keys.size()) {
        return (keys.substr(0, plus) == "Ctrl" ? "ctrl+" : "shift+") + keysymOf(keys.substr(plus + 1));
    }
    if (const auto found = others.find(keys); found != others.end()) {
        return found->second;
    }
    std::string name = keys;
    if (name.size() == 1) {
        name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    }
    return name;
}

class WindowKey : public WindowTest {};

TEST(KeyTable, HasNoKeyTwiceAndListsAll) {
    std::set<std::pair<int, int>> keys;
    std::set<std::string> names;
    const std::string table = viewer::keyTable();
    for (const viewer::KeyBinding& binding : viewer::keyBindings()) {
        EXPECT_TRUE(keys.emplace(binding.key, binding.modifiers).second) << binding.keys;
        EXPECT_TRUE(names.emplace(binding.keys).second) << binding.keys;
        EXPECT_NE(table.find(std::string("\n  ") + binding.keys + " "), std::string::npos) << binding.keys;
        EXPECT_STRNE(binding.description, "");
    }
    EXPECT_GT(keys.size(), 50U);
}

// What has to be pressed before a key can do something, and the event of it; nothing for most of them.
std::map<std::string, std::string> before(const std::string& keys) {
    static const std::map<std::string, std::map<std::string, std::string>> needed = {
        {"Home", {{"Left", "camera"}}}, {"F1", {{"F2", "camera"}}},          {"1", {{"2", "view"}}},
        {"C", {{"p", "picked"}}},       {"Shift+C", {{"p", "picked"}}},      {"X", {{"p", "picked"}}},
        {"Esc", {{"h", "shown"}}},      {"Backspace", {{"period", "time"}}}, {"0", {{"1", "view"}}}};
    const auto found = needed.find(keys);
    return found == needed.end() ? std::map<std::string, std::string>() : found->second;
}

// What a key of the group may cause.
bool isWork(const std::string& group, const std::string& event) {
    static const std::map<std::string, std::set<std::string>> events = {
        {"Camera", {"camera"}},
        {"View", {"view"}},
        {"Method", {"method", "wipe"}},
        {"Time", {"time"}},
        {"Picture", {"samples", "screenshot", "window-screenshot", "saved"}},
        {"Pixel", {"picked", "copied", "shown"}},
        {"Window", {"shown", "scene", "fullscreen", "minimised", "focus"}}};
    return events.at(group).contains(event);
}

TEST_F(WindowKey, EachDoesSomething) {
    open({scene("ring"), "--size", "48x32", "--no-panel", "--spp", "1"});
    for (const viewer::KeyBinding& binding : viewer::keyBindings()) {
        const std::string keys = binding.keys;
        // These have tests of their own, since they take the keys or the window away.
        if (keys == "Q" || keys == "F6" || keys == "F11") {
            continue;
        }
        SCOPED_TRACE(keys + ": " + binding.description);
        for (const auto& [key, event] : before(keys)) {
            press({key});
            await(event);
        }
        hand({"key", keysymOf(keys)});
        await("key", [&](const Json& event) { return event["code"] == binding.key; });
        while (!isWork(binding.group, nextEvent()["event"])) {
        }
    }
    close();
}

TEST_F(WindowKey, SeveralInAFrameAllCount) {
    open({scene("ring"), "--size", "48x32", "--no-panel", "--spp", "1"});
    // GLFW takes a key's second press within a millisecond for a fault of the keyboard: each but once.
    hand({"key", "--delay", "0", "Left", "Up", "w", "k", "2", "s", "e", "p", "h"});
    std::set<std::string> done;
    while (!done.contains(".exr") || !done.contains(".png") || !done.contains("picked")) {
        const Json event = nextEvent();
        const std::string name = event["event"];
        done.insert(name == "screenshot" ? fs::path(event["file"].get<std::string>()).extension().string()
                                         : name);
    }
    for (const char* event : {"camera", "wipe", "samples", "view", "shown"}) {
        EXPECT_TRUE(done.contains(event)) << event;
    }
    // They show what the keys before them have made.
    const Json moved = lastCamera;
    press({"ctrl+s"});
    const std::string saved = await("saved")["file"];
    EXPECT_TRUE(sameBits(rendered({saved, "--spp", "4"}), image::readImage(folder / "screenshot-001.exr")));
    EXPECT_TRUE(sameBits(screenshot("s"), image::readImage(folder / "screenshot-001.png")))
        << "the view of normals";

    hand({"key", "--delay", "0", "Down", "Right"});
    await("settled");
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double> home = {1.2, -3.3, 2.4};
        EXPECT_NEAR(lastCamera["position"][i].get<double>(), home[i], 1e-12);
        EXPECT_GT(std::abs(moved["position"][i].get<double>() - home[i]), 0.01);
    }
    EXPECT_NE(moved, lastCamera);
    close();
}

TEST_F(WindowKey, GoesToThePictureWhileThePanelIsOpenAndToThePanelWhenAskedTo) {
    open({scene("ring"), "--size", "640x480", "--spp", "1"});
    for (const char* key : {"Left", "Right", "Up", "Down", "Left"}) {
        hand({"keydown", key});
        await("camera");
        hand({"keyup", key});  // not later: a key that is held repeats, and then nothing settles
        await("settled");
    }

    press({"F6"});
    await("focus", [](const Json& event) { return event["panel"] == true; });
    // Down and up again within a frame, as keys are of quick hands and slow devices.
    hand({"key", "--delay", "0", "Down"});
    hand({"key", "--delay", "0", "Escape"});
    bool orbited = false;
    for (Json event = nextEvent(); event["event"] != "focus"; event = nextEvent()) {
        orbited = orbited || event["event"] == "camera";
    }
    EXPECT_FALSE(orbited);
    press({"Left"});
    await("camera");
    close();
}

TEST_F(WindowKey, WithAnUnknownModifierOrKeyDoesNothing) {
    open({scene("ring"), "--size", "48x32", "--no-panel", "--spp", "1"});
    hand({"key", "--delay", "0", "ctrl+q", "j", "F12", "ctrl+Left"});
    press({"h"});
    await("shown");
    hand({"key", "q"});
    expectEnd();
}

}  // namespace
}  // namespace raytorus::test
