// SPDX-License-Identifier: MIT
// The ways to draw a picture: one table, from which names and layouts are taken. How each draws is the table
// in picture_drawing.cpp.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>

#include "gpu/commands.hpp"

namespace raytorus::render {

enum class Route { Fragment, Compute };

struct RouteInfo {
    Route route;
    const char* name;      ///< on command lines, in tables and JSON
    gpu::Use use;          ///< how it writes the picture's images ...
    VkImageLayout layout;  ///< ... and in which layout
};

inline constexpr std::array routes = {
    RouteInfo{Route::Fragment, "fragment", gpu::colorWrite, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
    RouteInfo{Route::Compute, "compute", gpu::shaderWrite, VK_IMAGE_LAYOUT_GENERAL},
};

constexpr const RouteInfo& infoOf(Route route) {
    return routes[static_cast<std::size_t>(route)];
}
static_assert(infoOf(Route::Fragment).route == Route::Fragment &&
              infoOf(Route::Compute).route == Route::Compute);

/// The one after it, round and round.
constexpr Route nextOf(Route route) {
    return routes[(static_cast<std::size_t>(route) + 1) % routes.size()].route;
}

}  // namespace raytorus::render
