// SPDX-License-Identifier: MIT
#include "viewer/pointer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "viewer/navigation.hpp"

namespace raytorus::viewer {
namespace {

constexpr double clickDistance = 3.0;  // pixels that a hand may tremble in a click
constexpr double wipeDistance = 6.0;   // to the line of the wipe, in pixels
constexpr double turnPerHeight = 4.0;  // radians that a drag over the window's height turns
constexpr double dollyPerNotch = 1.1;

double wipeColumn(const State& state, VkRect2D picture) {
    return picture.offset.x + state.wipeAt * picture.extent.width;
}

}  // namespace

void Pointer::press(const InputEvent& event, const State& state, VkRect2D picture) {
    moved = false;
    pressX = lastX = event.x;
    pressY = lastY = event.y;
    const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT;
    if (left && state.wipe && std::abs(event.x - wipeColumn(state, picture)) <= wipeDistance) {
        held = Held::Wipe;
    } else if (left && (event.modifiers & GLFW_MOD_SHIFT) == 0) {
        held = Held::Orbit;
    } else {
        held = Held::Pan;
    }
}

void Pointer::move(const InputEvent& event, const PointerField& field, State& state) {
    if (held == Held::Nothing) {
        return;
    }
    moved = moved || std::hypot(event.x - pressX, event.y - pressY) > clickDistance;
    if (!moved) {
        return;
    }
    const double height = std::max(1U, field.window.height);
    const double x = (event.x - lastX) / height;
    const double y = (event.y - lastY) / height;
    lastX = event.x;
    lastY = event.y;
    if (held == Held::Orbit) {
        state.scene.camera = orbit(state.scene.camera, -turnPerHeight * x, turnPerHeight * y);
    } else if (held == Held::Pan) {
        state.scene.camera = pan(state.scene.camera, x, -y);
    } else {
        state.wipeAt = std::clamp(
            (event.x - field.picture.offset.x) / std::max(1U, field.picture.extent.width), 0.0, 1.0);
    }
}

// extent: of the picture itself, whose pixels may be larger than those of the window.
void Pointer::release(const InputEvent& event, VkRect2D picture, VkExtent2D extent, CommandQueue& commands) {
    const bool click = held != Held::Nothing && !moved && event.code == GLFW_MOUSE_BUTTON_LEFT;
    held = Held::Nothing;
    if (!click || picture.extent.width == 0 || picture.extent.height == 0) {
        return;
    }
    const double x = (event.x - picture.offset.x) / picture.extent.width * extent.width;
    const double y = (event.y - picture.offset.y) / picture.extent.height * extent.height;
    if (x >= 0.0 && y >= 0.0 && x < extent.width && y < extent.height) {
        commands.push(TakeApart{static_cast<int>(x), static_cast<int>(y)});
    }
}

void Pointer::handle(const InputEvent& event, const PointerField& field, State& state,
                     CommandQueue& commands) {
    switch (event.type) {
        case InputEvent::Type::Button:
            if (event.pressed && !field.panel && held == Held::Nothing) {
                press(event, state, field.picture);
            } else if (!event.pressed) {
                release(event, field.picture, state.statistics.extent, commands);
            }
            break;
        case InputEvent::Type::Move:
            move(event, field, state);
            break;
        case InputEvent::Type::Scroll:
            if (!field.panel) {
                state.scene.camera = dolly(state.scene.camera, std::pow(dollyPerNotch, event.y));
            }
            break;
        default:
            break;
    }
}

}  // namespace raytorus::viewer
