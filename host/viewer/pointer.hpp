// SPDX-License-Identifier: MIT
// What the pointer does to the picture: drags turn and move the camera, the wheel brings it nearer, a click
// asks for a pixel.
#pragma once

#include "viewer/commands.hpp"
#include "viewer/state.hpp"
#include "viewer/window.hpp"

namespace raytorus::viewer {

/// What the pointer moves over, in framebuffer pixels.
struct PointerField {
    VkExtent2D window{};  ///< all of it
    VkRect2D picture{};   ///< where the picture is
    bool panel = false;   ///< the pointer is on a panel, whose the event is
};

class Pointer {
public:
    void handle(const InputEvent& event, const PointerField& field, State& state, CommandQueue& commands);

private:
    enum class Held { Nothing, Orbit, Pan, Wipe };

    void press(const InputEvent& event, const State& state, VkRect2D picture);
    void move(const InputEvent& event, const PointerField& field, State& state);
    void release(const InputEvent& event, VkRect2D picture, VkExtent2D extent, CommandQueue& commands);

    Held held = Held::Nothing;
    bool moved = false;
    double pressX = 0.0, pressY = 0.0;
    double lastX = 0.0, lastY = 0.0;
};

}  // namespace raytorus::viewer
