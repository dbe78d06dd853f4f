// SPDX-License-Identifier: MIT
// Scene to picture, by the fragment or the compute route.
#pragma once

#include <functional>
#include <optional>

#include "gpu/context.hpp"
#include "image/image.hpp"
#include "render/scene.hpp"
#include "render/shader_source.hpp"

namespace raytorus::render {

enum class Route { Fragment, Compute };

struct RenderOptions {
    Route route = Route::Fragment;
    int width = 0;           ///< 0: the scene's
    int height = 0;          ///< 0: the scene's
    int samplesPerSide = 1;  ///< colour is the mean of a regular grid of n x n rays a pixel
    bool aovs = true;        ///< the geometric pictures too; see PictureTargets for the channels
    ShaderSource shaders;
    std::function<void(double)> progress;  ///< called with the part done, in (0, 1]
};

/// Seconds of wall time, and what was done in them.
struct RenderTimes {
    double scene = 0.0;     ///< hierarchy and buffers
    double pipeline = 0.0;  ///< shader modules, pipeline, images
    /// The first band of rows. Drivers that compile at the first use do so here.
    double firstBand = 0.0;
    double otherBands = 0.0;
    double readBack = 0.0;
    std::int64_t firstPixels = 0;
    std::int64_t otherPixels = 0;
    /// The device's own time for the other bands, where it has timestamps.
    std::optional<double> deviceOtherBands;
};

struct RenderResult {
    image::Image picture;
    RenderTimes times;
};

RenderResult render(gpu::Context& context, const Scene& scene, const RenderOptions& options);

}  // namespace raytorus::render
