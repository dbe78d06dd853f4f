// SPDX-License-Identifier: MIT
// Scene to picture, by the fragment or the compute route.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "gpu/context.hpp"
#include "image/image.hpp"
#include "render/picture_drawing.hpp"
#include "scene/scene.hpp"

namespace raytorus::render {

struct RenderOptions {
    Route route = Route::Fragment;
    int width = 0;           ///< 0: the scene's
    int height = 0;          ///< 0: the scene's
    int samplesPerSide = 1;  ///< colour is the mean of a regular grid of n x n rays a pixel
    int repeats = 1;         ///< render so many times and report the fastest; the pictures are the same
    bool aovs = true;        ///< the geometric pictures too; see PictureTargets for the channels
    trace::ShaderSource shaders;
    PipelineStore* pipelines = nullptr;    ///< null: one is made, and goes
    std::function<void(double)> progress;  ///< called with the part done, in (0, 1]
};

/// Width and height of the picture: what the options say, or else the scene.
std::pair<int, int> pictureSize(const scene::Scene& scene, const RenderOptions& options);

/// One pass over the picture, in seconds of wall time. The first band of rows is told apart because drivers
/// that compile at the first use do so there.
struct PassTimes {
    double firstBand = 0.0;
    double otherBands = 0.0;
    double deviceOtherBands = 0.0;  ///< the device's own time; 0 where it has no timestamps
    std::int64_t firstPixels = 0;
    std::int64_t otherPixels = 0;

    [[nodiscard]] double total() const { return firstBand + otherBands; }
};

struct RenderTimes {
    double scene = 0.0;     ///< hierarchy and buffers
    double pipeline = 0.0;  ///< shader modules, pipeline, images
    PassTimes firstPass;
    std::optional<PassTimes>
        fastestRepeat;  ///< with RenderOptions::repeats > 1: nothing in it happens for the first time
    double readBack = 0.0;
};

struct RenderResult {
    image::Image picture;
    RenderTimes times;
};

RenderResult render(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options);

}  // namespace raytorus::render
