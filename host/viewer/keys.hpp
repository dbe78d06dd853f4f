// SPDX-License-Identifier: MIT
// Every key and what it does: one table for the keyboard, the help on the screen and the documentation.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "viewer/commands.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

struct KeyBinding {
    const char* keys;  ///< as shown: "Shift+Left"
    int key;           ///< GLFW's
    int modifiers;     ///< GLFW_MOD_SHIFT and GLFW_MOD_CONTROL, nothing else is told apart
    const char* group;
    const char* description;
    void (*change)(State&) = nullptr;  ///< at once
    std::optional<Command> (*ask)(const State&) = nullptr;
};

std::span<const KeyBinding> keyBindings();

/// Does what the key is bound to. False: to nothing.
bool pressKey(int key, int modifiers, State& state, CommandQueue& commands);

/// A line a key, in groups, as `--list-keys` prints them.
std::string keyTable();

/// "shift+left drag" and the like: what the pointer does.
struct Gesture {
    const char* gesture;
    const char* description;
};
std::span<const Gesture> gestures();

}  // namespace raytorus::viewer
