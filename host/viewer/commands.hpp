// SPDX-License-Identifier: MIT
// Every key and what it does: one table for the keyboard, the help on the screen and the documentation.
#pragma once

#include <span>
#include <string>

#include "viewer/state.hpp"

namespace raytorus::viewer {

struct Command {
    const char* keys;  ///< as shown: "Shift+Left"
    int key;           ///< GLFW's
    int modifiers;     ///< GLFW_MOD_SHIFT and GLFW_MOD_CONTROL, nothing else is told apart
    const char* group;
    const char* description;
    void (*run)(State&);
};

std::span<const Command> commands();

/// Runs the command of a key. False: there is none.
bool runCommand(State& state, int key, int modifiers);

/// A line a command, in groups, as `--list-keys` prints them.
std::string keyTable();

/// "shift+left drag" and the like: what the pointer does.
struct Gesture {
    const char* gesture;
    const char* description;
};
std::span<const Gesture> gestures();

}  // namespace raytorus::viewer
