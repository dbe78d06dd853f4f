// SPDX-License-Identifier: MIT
#include "viewer/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "viewer/navigation.hpp"

namespace raytorus::viewer {
namespace {

constexpr int shift = GLFW_MOD_SHIFT;
constexpr int control = GLFW_MOD_CONTROL;

constexpr double turnPerStroke = 0.1;  // radians a key stroke
constexpr double shove = 0.05;         // of the picture's height
constexpr double approach = 1.1;       // of the distance
constexpr double frameTime = 1.0 / 30.0;

template <int across, int upwards>
void orbitBy(State& state) {
    state.scene.camera = orbit(state.scene.camera, turnPerStroke * across, turnPerStroke * upwards);
}

template <int x, int y>
void panBy(State& state) {
    state.scene.camera = pan(state.scene.camera, shove * x, shove * y);
}

template <bool nearer>
void dollyBy(State& state) {
    state.scene.camera = dolly(state.scene.camera, nearer ? approach : 1.0 / approach);
}

double aspectRatio(const State& state) {
    const VkExtent2D extent = state.statistics.extent;
    return extent.height == 0 ? 1.5 : static_cast<double>(extent.width) / extent.height;
}

template <Preset which>
void lookFrom(State& state) {
    state.scene.camera = preset(which, state.scene.camera, state.scene.tori, aspectRatio(state));
}

template <PictureView which>
void show(State& state) {
    state.view = which;
}

template <int step>
void nextView(State& state) {
    const int count = static_cast<int>(views().size());
    state.view = static_cast<PictureView>((static_cast<int>(state.view) + count + step) % count);
}

template <int step>
void nextMethod(State& state) {
    const std::size_t count = state.methods.size();
    state.left.method = (state.left.method + (step > 0 ? 1 : count - 1)) % count;
}

void nextRightMethod(State& state) {
    state.right.method = (state.right.method + 1) % state.methods.size();
    state.wipe = true;
}

template <int step>
void moveWipe(State& state) {
    state.wipe = true;
    state.wipeAt = std::clamp(state.wipeAt + 0.05 * step, 0.0, 1.0);
}

template <int frames>
void stepTime(State& state) {
    state.animation.playing = false;
    state.animation.seconds += frames * frameTime;
}

template <int doublings>
void speedUp(State& state) {
    state.animation.speed = std::clamp(std::ldexp(state.animation.speed, doublings), 1.0 / 64.0, 64.0);
}

template <int step>
void moreSamples(State& state) {
    state.samplesPerSide = std::clamp(state.samplesPerSide + step, 1, 16);
}

template <bool State::*shown>
void toggle(State& state) {
    state.*shown = !(state.*shown);
}

template <Side State::*side>
void nextRoute(State& state) {
    (state.*side).route = render::nextOf((state.*side).route);
}

void fitAll(State& state) {
    state.scene.camera = fit(state.scene.camera, state.scene.tori, aspectRatio(state));
}

void goHome(State& state) {
    state.scene.camera = state.fileScene.camera;
}

void pauseOrGoOn(State& state) {
    state.animation.playing = !state.animation.playing;
}

void goToBeginning(State& state) {
    state.animation.seconds = 0.0;
}

void showPanel(State& state) {
    state.panel = true;
}

void closePick(State& state) {
    state.pick.reset();
}

void closeOverlays(State& state) {
    state.help = false;
    state.pick.reset();
}

template <class Asked>
std::optional<Command> ask(const State&) {
    return Asked{};
}

std::optional<Command> savePng(const State&) {
    return SavePicture{".png"};
}

std::optional<Command> saveExr(const State&) {
    return SavePicture{".exr"};
}

template <std::string Pick::*text>
std::optional<Command> copy(const State& state) {
    if (!state.pick) {
        return std::nullopt;
    }
    return CopyText{(*state.pick).*text};
}

std::optional<Command> takeMiddleApart(const State& state) {
    const VkExtent2D extent = state.statistics.extent;
    return TakeApart{static_cast<int>(extent.width / 2), static_cast<int>(extent.height / 2)};
}

const KeyBinding bindings[] = {
    {"Left", GLFW_KEY_LEFT, 0, "Camera", "orbit", orbitBy<-1, 0>},
    {"Right", GLFW_KEY_RIGHT, 0, "Camera", "orbit", orbitBy<1, 0>},
    {"Up", GLFW_KEY_UP, 0, "Camera", "orbit", orbitBy<0, 1>},
    {"Down", GLFW_KEY_DOWN, 0, "Camera", "orbit", orbitBy<0, -1>},
    {"Shift+Left", GLFW_KEY_LEFT, shift, "Camera", "pan", panBy<-1, 0>},
    {"Shift+Right", GLFW_KEY_RIGHT, shift, "Camera", "pan", panBy<1, 0>},
    {"Shift+Up", GLFW_KEY_UP, shift, "Camera", "pan", panBy<0, 1>},
    {"Shift+Down", GLFW_KEY_DOWN, shift, "Camera", "pan", panBy<0, -1>},
    {"=", GLFW_KEY_EQUAL, 0, "Camera", "nearer", dollyBy<true>},
    {"-", GLFW_KEY_MINUS, 0, "Camera", "farther", dollyBy<false>},
    {"F", GLFW_KEY_F, 0, "Camera", "fit all tori into the picture", fitAll},
    {"Home", GLFW_KEY_HOME, 0, "Camera", "the scene's own camera", goHome},
    {"F1", GLFW_KEY_F1, 0, "Camera", "from the front", lookFrom<Preset::Front>},
    {"F2", GLFW_KEY_F2, 0, "Camera", "from the right", lookFrom<Preset::Right>},
    {"F3", GLFW_KEY_F3, 0, "Camera", "from the top", lookFrom<Preset::Top>},
    {"Shift+F1", GLFW_KEY_F1, shift, "Camera", "from the back", lookFrom<Preset::Back>},
    {"Shift+F2", GLFW_KEY_F2, shift, "Camera", "from the left", lookFrom<Preset::Left>},
    {"Shift+F3", GLFW_KEY_F3, shift, "Camera", "from below", lookFrom<Preset::Bottom>},
    {"F4", GLFW_KEY_F4, 0, "Camera", "from a corner", lookFrom<Preset::Corner>},
    {"1", GLFW_KEY_1, 0, "View", "shaded", show<PictureView::Shaded>},
    {"2", GLFW_KEY_2, 0, "View", "normal", show<PictureView::Normal>},
    {"3", GLFW_KEY_3, 0, "View", "uv", show<PictureView::Uv>},
    {"4", GLFW_KEY_4, 0, "View", "depth", show<PictureView::Depth>},
    {"5", GLFW_KEY_5, 0, "View", "surfaces", show<PictureView::Count>},
    {"6", GLFW_KEY_6, 0, "View", "torus", show<PictureView::Torus>},
    {"7", GLFW_KEY_7, 0, "View", "steps of the solver", show<PictureView::Steps>},
    {"8", GLFW_KEY_8, 0, "View", "distance from the surface", show<PictureView::Surface>},
    {"9", GLFW_KEY_9, 0, "View", "difference to the reference", show<PictureView::Reference>},
    {"0", GLFW_KEY_0, 0, "View", "difference to the golden picture", show<PictureView::Golden>},
    {"V", GLFW_KEY_V, 0, "View", "next view", nextView<1>},
    {"Shift+V", GLFW_KEY_V, shift, "View", "view before", nextView<-1>},
    {"M", GLFW_KEY_M, 0, "Method", "next method", nextMethod<1>},
    {"Shift+M", GLFW_KEY_M, shift, "Method", "method before", nextMethod<-1>},
    {"R", GLFW_KEY_R, 0, "Method", "other route", nextRoute<&State::left>},
    {"W", GLFW_KEY_W, 0, "Method", "wipe between two methods or routes on and off", toggle<&State::wipe>},
    {"N", GLFW_KEY_N, 0, "Method", "next method on the right of the wipe", nextRightMethod},
    {"Shift+R", GLFW_KEY_R, shift, "Method", "other route on the right of the wipe",
     nextRoute<&State::right>},
    {"[", GLFW_KEY_LEFT_BRACKET, 0, "Method", "wipe to the left", moveWipe<-1>},
    {"]", GLFW_KEY_RIGHT_BRACKET, 0, "Method", "wipe to the right", moveWipe<1>},
    {"Space", GLFW_KEY_SPACE, 0, "Time", "pause and go on", pauseOrGoOn},
    {".", GLFW_KEY_PERIOD, 0, "Time", "a thirtieth of a second on", stepTime<1>},
    {",", GLFW_KEY_COMMA, 0, "Time", "and back", stepTime<-1>},
    {"PageUp", GLFW_KEY_PAGE_UP, 0, "Time", "twice as fast", speedUp<1>},
    {"PageDown", GLFW_KEY_PAGE_DOWN, 0, "Time", "half as fast", speedUp<-1>},
    {"Backspace", GLFW_KEY_BACKSPACE, 0, "Time", "back to the beginning", goToBeginning},
    {"K", GLFW_KEY_K, 0, "Picture", "more samples at rest", moreSamples<1>},
    {"Shift+K", GLFW_KEY_K, shift, "Picture", "fewer samples", moreSamples<-1>},
    {"S", GLFW_KEY_S, 0, "Picture", "save the picture as PNG: screenshot-001.png, ...", nullptr, savePng},
    {"E", GLFW_KEY_E, 0, "Picture", "save the picture as EXR, with every channel", nullptr, saveExr},
    {"Shift+S", GLFW_KEY_S, shift, "Picture", "save the window with its panels: window-001.png, ...", nullptr,
     ask<SaveWindow>},
    {"Ctrl+S", GLFW_KEY_S, control, "Picture", "save the scene as it is now: scene-001.json, ...", nullptr,
     ask<SaveScene>},
    {"P", GLFW_KEY_P, 0, "Pixel", "take the pixel in the middle apart", nullptr, takeMiddleApart},
    {"C", GLFW_KEY_C, 0, "Pixel", "copy its raytorus explain command", nullptr, copy<&Pick::command>},
    {"Shift+C", GLFW_KEY_C, shift, "Pixel", "copy it as a test case", nullptr, copy<&Pick::testCase>},
    {"X", GLFW_KEY_X, 0, "Pixel", "close it", closePick},
    {"Tab", GLFW_KEY_TAB, 0, "Window", "panel on and off", toggle<&State::panel>},
    {"F6", GLFW_KEY_F6, 0, "Window", "the keys go to the panel: arrows, Space, Ctrl+Tab; Esc ends it",
     showPanel, ask<FocusPanel>},
    {"?", GLFW_KEY_SLASH, shift, "Window", "this help", toggle<&State::help>},
    {"H", GLFW_KEY_H, 0, "Window", "this help", toggle<&State::help>},
    {"F5", GLFW_KEY_F5, 0, "Window", "read the scene and the edited shaders again", nullptr,
     ask<ReadFilesAgain>},
    {"F11", GLFW_KEY_F11, 0, "Window", "full screen on and off", nullptr, ask<ToggleFullScreen>},
    {"Shift+F11", GLFW_KEY_F11, shift, "Window", "minimise", nullptr, ask<Minimise>},
    {"Esc", GLFW_KEY_ESCAPE, 0, "Window", "close what lies over the picture", closeOverlays},
    {"Q", GLFW_KEY_Q, 0, "Window", "quit", nullptr, ask<Quit>},
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

std::span<const KeyBinding> keyBindings() {
    return bindings;
}

std::span<const Gesture> gestures() {
    return gestureList;
}

bool pressKey(int key, int modifiers, State& state, CommandQueue& commands) {
    const int told = modifiers & (shift | control);
    const auto found = std::ranges::find_if(
        bindings, [&](const KeyBinding& binding) { return binding.key == key && binding.modifiers == told; });
    if (found == std::end(bindings)) {
        return false;
    }
    if (found->change != nullptr) {
        found->change(state);
    }
    if (found->ask != nullptr) {
        if (std::optional<Command> asked = found->ask(state)) {
            commands.push(std::move(*asked));
        }
    }
    return true;
}

std::string keyTable() {
    std::string text;
    std::string_view group;
    for (const KeyBinding& binding : bindings) {
        if (group != binding.group) {
            group = binding.group;
            text += fmt::format("{}\n", group);
        }
        text += fmt::format("  {:12} {}\n", binding.keys, binding.description);
    }
    text += "Pointer\n";
    for (const Gesture& gesture : gestureList) {
        text += fmt::format("  {:33} {}\n", gesture.gesture, gesture.description);
    }
    return text;
}

}  // namespace raytorus::viewer
