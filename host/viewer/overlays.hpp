// SPDX-License-Identifier: MIT
// What lies over the picture: the help, a pixel taken apart, an error of the edited shaders, a short message,
// the line of the wipe.
#pragma once

#include <vulkan/vulkan.h>

#include "viewer/method_list.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

/// pixels: where in the framebuffer the picture is. now: the loop's clock.
void drawOverlays(State& state, const std::vector<MethodEntry>& methods, VkRect2D pixels, double now);

}  // namespace raytorus::viewer
