// SPDX-License-Identifier: MIT
// What the pointer does to the picture: drags turn and move the camera, the wheel brings it nearer, a click
// asks for a pixel.
#pragma once

#include "viewer/state.hpp"
#include "viewer/window.hpp"

namespace raytorus::viewer {

class Pointer {
public:
    /// `window`: the framebuffer. `picture`: where in it the picture is. `captured`: the pointer is on a
    /// panel.
    void handle(const InputEvent& event, State& state, VkExtent2D window, VkRect2D picture, bool captured);

    /// Whether a button is held that was pressed on the picture.
    [[nodiscard]] bool dragging() const { return held != Held::Nothing; }

private:
    enum class Held { Nothing, Orbit, Pan, Wipe };

    void press(const InputEvent& event, const State& state, VkRect2D picture);
    void move(const InputEvent& event, State& state, VkExtent2D window, VkRect2D picture);
    void release(const InputEvent& event, State& state, VkRect2D picture);

    Held held = Held::Nothing;
    bool moved = false;
    double pressX = 0.0, pressY = 0.0;
    double lastX = 0.0, lastY = 0.0;
};

}  // namespace raytorus::viewer
