// SPDX-License-Identifier: MIT
#include "viewer/commands.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "viewer/navigation.hpp"

namespace raytorus::viewer {
namespace {

constexpr int shift = GLFW_MOD_SHIFT;
constexpr int control = GLFW_MOD_CONTROL;

constexpr double turn = 0.1;      // radians a key stroke
constexpr double shove = 0.05;    // of the picture's height
constexpr double approach = 1.1;  // of the distance
constexpr double frameTime = 1.0 / 30.0;

template <int across, int upwards>
void orbitBy(State& state) {
    state.scene.camera = orbit(state.scene.camera, turn * across, turn * upwards);
}

template <int x, int y>
void panBy(State& state) {
    state.scene.camera = pan(state.scene.camera, shove * x, shove * y);
}

template <bool nearer>
void dollyBy(State& state) {
    state.scene.camera = dolly(state.scene.camera, nearer ? approach : 1.0 / approach);
}

template <Preset which>
void lookFrom(State& state) {
    state.scene.camera = preset(which, state.scene.camera, state.scene.tori, aspectRatio(state));
}

template <View which>
void show(State& state) {
    state.view = which;
}

template <int step>
void nextView(State& state) {
    const int count = static_cast<int>(views().size());
    state.view = static_cast<View>((static_cast<int>(state.view) + count + step) % count);
}

template <int step>
void nextMethod(State& state) {
    const std::size_t count = state.methodCount;
    state.left.method = (state.left.method + (step > 0 ? 1 : count - 1)) % count;
}

void nextRightMethod(State& state) {
    state.right.method = (state.right.method + 1) % state.methodCount;
    state.wipe = true;
}

template <int step>
void moveWipe(State& state) {
    state.wipe = true;
    state.wipeAt = std::clamp(state.wipeAt + 0.05 * step, 0.0, 1.0);
}

void stepTime(State& state, double frames) {
    state.animation.playing = false;
    state.animation.seconds += frames * frameTime;
}

void faster(State& state, double factor) {
    state.animation.speed = std::clamp(state.animation.speed * factor, 1.0 / 64.0, 64.0);
}

void moreSamples(State& state, int step) {
    state.samplesPerSide = std::clamp(state.samplesPerSide + step, 1, 16);
}

void copy(State& state, const std::string& text) {
    if (!text.empty()) {
        state.clipboardRequest = text;
    }
}

const std::array list = {
    Command{"Left", GLFW_KEY_LEFT, 0, "Camera", "orbit", orbitBy<-1, 0>},
    Command{"Right", GLFW_KEY_RIGHT, 0, "Camera", "orbit", orbitBy<1, 0>},
    Command{"Up", GLFW_KEY_UP, 0, "Camera", "orbit", orbitBy<0, 1>},
    Command{"Down", GLFW_KEY_DOWN, 0, "Camera", "orbit", orbitBy<0, -1>},
    Command{"Shift+Left", GLFW_KEY_LEFT, shift, "Camera", "pan", panBy<-1, 0>},
    Command{"Shift+Right", GLFW_KEY_RIGHT, shift, "Camera", "pan", panBy<1, 0>},
    Command{"Shift+Up", GLFW_KEY_UP, shift, "Camera", "pan", panBy<0, 1>},
    Command{"Shift+Down", GLFW_KEY_DOWN, shift, "Camera", "pan", panBy<0, -1>},
    Command{"=", GLFW_KEY_EQUAL, 0, "Camera", "nearer", dollyBy<true>},
    Command{"-", GLFW_KEY_MINUS, 0, "Camera", "farther", dollyBy<false>},
    Command{"F", GLFW_KEY_F, 0, "Camera", "fit all tori into the picture",
            [](State& state) {
                state.scene.camera = fit(state.scene.camera, state.scene.tori, aspectRatio(state));
            }},
    Command{"Home", GLFW_KEY_HOME, 0, "Camera", "the scene's own camera",
            [](State& state) { state.scene.camera = state.fileScene.camera; }},
    Command{"F1", GLFW_KEY_F1, 0, "Camera", "from the front", lookFrom<Preset::Front>},
    Command{"F2", GLFW_KEY_F2, 0, "Camera", "from the right", lookFrom<Preset::Right>},
    Command{"F3", GLFW_KEY_F3, 0, "Camera", "from the top", lookFrom<Preset::Top>},
    Command{"Shift+F1", GLFW_KEY_F1, shift, "Camera", "from the back", lookFrom<Preset::Back>},
    Command{"Shift+F2", GLFW_KEY_F2, shift, "Camera", "from the left", lookFrom<Preset::Left>},
    Command{"Shift+F3", GLFW_KEY_F3, shift, "Camera", "from below", lookFrom<Preset::Bottom>},
    Command{"F4", GLFW_KEY_F4, 0, "Camera", "from a corner", lookFrom<Preset::Corner>},

    Command{"1", GLFW_KEY_1, 0, "View", "shaded", show<View::Shaded>},
    Command{"2", GLFW_KEY_2, 0, "View", "normal", show<View::Normal>},
    Command{"3", GLFW_KEY_3, 0, "View", "uv", show<View::Uv>},
    Command{"4", GLFW_KEY_4, 0, "View", "depth", show<View::Depth>},
    Command{"5", GLFW_KEY_5, 0, "View", "surfaces", show<View::Count>},
    Command{"6", GLFW_KEY_6, 0, "View", "torus", show<View::Torus>},
    Command{"7", GLFW_KEY_7, 0, "View", "steps of the solver", show<View::Steps>},
    Command{"8", GLFW_KEY_8, 0, "View", "distance from the surface", show<View::Surface>},
    Command{"9", GLFW_KEY_9, 0, "View", "difference to the reference", show<View::Reference>},
    Command{"0", GLFW_KEY_0, 0, "View", "difference to the golden picture", show<View::Golden>},
    Command{"V", GLFW_KEY_V, 0, "View", "next view", nextView<1>},
    Command{"Shift+V", GLFW_KEY_V, shift, "View", "view before", nextView<-1>},

    Command{"M", GLFW_KEY_M, 0, "Method", "next method", nextMethod<1>},
    Command{"Shift+M", GLFW_KEY_M, shift, "Method", "method before", nextMethod<-1>},
    Command{"R", GLFW_KEY_R, 0, "Method", "other route",
            [](State& state) { state.left.route = render::nextOf(state.left.route); }},
    Command{"W", GLFW_KEY_W, 0, "Method", "wipe between two methods or routes on and off",
            [](State& state) { state.wipe = !state.wipe; }},
    Command{"N", GLFW_KEY_N, 0, "Method", "next method on the right of the wipe", nextRightMethod},
    Command{"Shift+R", GLFW_KEY_R, shift, "Method", "other route on the right of the wipe",
            [](State& state) { state.right.route = render::nextOf(state.right.route); }},
    Command{"[", GLFW_KEY_LEFT_BRACKET, 0, "Method", "wipe to the left", moveWipe<-1>},
    Command{"]", GLFW_KEY_RIGHT_BRACKET, 0, "Method", "wipe to the right", moveWipe<1>},

    Command{"Space", GLFW_KEY_SPACE, 0, "Time", "pause and go on",
            [](State& state) { state.animation.playing = !state.animation.playing; }},
    Command{".", GLFW_KEY_PERIOD, 0, "Time", "a thirtieth of a second on", [](State& state) { stepTime(state, 1.0); }},
    Command{",", GLFW_KEY_COMMA, 0, "Time", "and back", [](State& state) { stepTime(state, -1.0); }},
    Command{"PageUp", GLFW_KEY_PAGE_UP, 0, "Time", "twice as fast", [](State& state) { faster(state, 2.0); }},
    Command{"PageDown", GLFW_KEY_PAGE_DOWN, 0, "Time", "half as fast", [](State& state) { faster(state, 0.5); }},
    Command{"Backspace", GLFW_KEY_BACKSPACE, 0, "Time", "back to the beginning",
            [](State& state) { state.animation.seconds = 0.0; }},

    Command{"K", GLFW_KEY_K, 0, "Picture", "more samples at rest", [](State& state) { moreSamples(state, 1); }},
    Command{"Shift+K", GLFW_KEY_K, shift, "Picture", "fewer samples", [](State& state) { moreSamples(state, -1); }},
    Command{"S", GLFW_KEY_S, 0, "Picture", "save the picture as PNG: screenshot-001.png, ...",
            [](State& state) { state.screenshotRequests.push_back(".png"); }},
    Command{"E", GLFW_KEY_E, 0, "Picture", "save the picture as EXR, with every channel",
            [](State& state) { state.screenshotRequests.push_back(".exr"); }},
    Command{"Shift+S", GLFW_KEY_S, shift, "Picture", "save the window with its panels: window-001.png, ...",
            [](State& state) { state.windowShotRequest = true; }},
    Command{"Ctrl+S", GLFW_KEY_S, control, "Picture", "save the scene as it is now: scene-001.json, ...",
            [](State& state) { state.saveRequest = true; }},

    Command{"P", GLFW_KEY_P, 0, "Pixel", "take the pixel in the middle apart",
            [](State& state) {
                state.pickRequest = std::pair(static_cast<int>(state.statistics.extent.width / 2),
                                              static_cast<int>(state.statistics.extent.height / 2));
            }},
    Command{"C", GLFW_KEY_C, 0, "Pixel", "copy its raytorus explain command",
            [](State& state) { copy(state, state.pick ? state.pick->command : ""); }},
    Command{"Shift+C", GLFW_KEY_C, shift, "Pixel", "copy it as a test case",
            [](State& state) { copy(state, state.pick ? state.pick->testCase : ""); }},
    Command{"X", GLFW_KEY_X, 0, "Pixel", "close it", [](State& state) { state.pick.reset(); }},

    Command{"Tab", GLFW_KEY_TAB, 0, "Window", "panel on and off", [](State& state) { state.panel = !state.panel; }},
    Command{"F6", GLFW_KEY_F6, 0, "Window", "the keys go to the panel: arrows, Space, Ctrl+Tab; Esc ends it",
            [](State& state) {
                state.panel = true;
                state.panelFocusRequest = true;
            }},
    Command{"?", GLFW_KEY_SLASH, shift, "Window", "this help", [](State& state) { state.help = !state.help; }},
    Command{"H", GLFW_KEY_H, 0, "Window", "this help", [](State& state) { state.help = !state.help; }},
    Command{"F5", GLFW_KEY_F5, 0, "Window", "read the scene and the edited shaders again",
            [](State& state) { state.reloadRequest = true; }},
    Command{"F11", GLFW_KEY_F11, 0, "Window", "full screen on and off",
            [](State& state) { state.fullScreenRequest = true; }},
    Command{"Shift+F11", GLFW_KEY_F11, shift, "Window", "minimise",
            [](State& state) { state.minimiseRequest = true; }},
    Command{"Esc", GLFW_KEY_ESCAPE, 0, "Window", "close what lies over the picture",
            [](State& state) {
                state.help = false;
                state.pick.reset();
            }},
    Command{"Q", GLFW_KEY_Q, 0, "Window", "quit", [](State& state) { state.closing = true; }},
};

constexpr std::array<Gesture, 6> gestureList = {{
    {"left drag", "orbit"},
    {"right, middle or Shift+left drag", "pan"},
    {"wheel or two fingers", "nearer, farther"},
    {"click", "take the pixel apart"},
    {"drag at the wipe's line", "move it"},
    {"drop a scene file", "open it"},
}};

}  // namespace

double aspectRatio(const State& state) {
    const VkExtent2D extent = state.statistics.extent;
    return extent.height == 0 ? 1.5 : static_cast<double>(extent.width) / extent.height;
}

std::span<const Command> commands() {
    return list;
}

std::span<const Gesture> gestures() {
    return gestureList;
}

bool runCommand(State& state, int key, int modifiers) {
    const int told = modifiers & (shift | control);
    const auto found = std::ranges::find_if(
        list, [&](const Command& command) { return command.key == key && command.modifiers == told; });
    if (found == list.end()) {
        return false;
    }
    found->run(state);
    return true;
}

std::string keyTable() {
    std::string text;
    std::string_view group;
    for (const Command& command : list) {
        if (group != command.group) {
            group = command.group;
            text += fmt::format("{}\n", group);
        }
        text += fmt::format("  {:12} {}\n", command.keys, command.description);
    }
    text += "Pointer\n";
    for (const Gesture& gesture : gestureList) {
        text += fmt::format("  {:33} {}\n", gesture.gesture, gesture.description);
    }
    return text;
}

}  // namespace raytorus::viewer
