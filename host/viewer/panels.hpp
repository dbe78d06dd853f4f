// SPDX-License-Identifier: MIT
// What ImGui draws over the picture. All of it changes the state as the user says, and pushes commands.
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "viewer/commands.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

/// Everything that can be changed, and the numbers of what is shown. device: its name and driver. focus: the
/// panel is given the keys.
void drawPanel(State& state, CommandQueue& commands, const std::string& device, bool focus);

/// The part of the panel with tori, materials, lights and camera.
void drawScenePanel(State& state, CommandQueue& commands);

/// The help, a pixel taken apart, an error of the edited shaders, a short message, the line of the wipe.
/// pixels: where in the framebuffer the picture is. now: the loop's clock.
void drawOverlays(State& state, CommandQueue& commands, VkRect2D pixels, double now);

}  // namespace raytorus::viewer
