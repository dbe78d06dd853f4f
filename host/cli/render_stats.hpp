// SPDX-License-Identifier: MIT
// Where the time of `raytorus render` went, as text or JSON.
#pragma once

#include <string>

#include "gpu/device.hpp"
#include "render/renderer.hpp"

namespace raytorus::cli {

/// Seconds of wall time, and what they were for.
struct RenderStats {
    gpu::DeviceInfo device;
    render::Route route = render::Route::Fragment;
    int width = 0;
    int height = 0;
    int samplesPerPixel = 1;
    double read = 0.0;      ///< the scene file
    double instance = 0.0;  ///< Vulkan instance and device
    render::RenderTimes render;
    double write = 0.0;  ///< the picture file
    double total = 0.0;  ///< all of it, from the start of the command
};

std::string statsText(const RenderStats& stats);
std::string statsJson(const RenderStats& stats);

}  // namespace raytorus::cli
