// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include <chrono>

#include "render/picture_targets.hpp"
#include "render/scene_buffers.hpp"

namespace raytorus::render {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double bandSeconds = 0.25;  // a GPU's watchdog ends what runs for seconds

PassTimes drawPass(PictureDrawing& drawing, const RenderOptions& options) {
    const VkExtent2D extent = drawing.extent();
    PassTimes times;
    for (drawing.restart(); !drawing.complete();) {
        const Band band = drawing.drawBand(bandSeconds);
        const bool first = band.firstRow == 0;
        (first ? times.firstBand : times.otherBands) += band.seconds;
        (first ? times.firstPixels : times.otherPixels) +=
            std::int64_t{extent.width} * (band.endRow - band.firstRow);
        times.deviceOtherBands += first ? 0.0 : band.deviceSeconds;
        if (options.progress) {
            options.progress(static_cast<double>(band.endRow) / extent.height);
        }
    }
    return times;
}

void drawPasses(PictureDrawing& drawing, const RenderOptions& options, RenderTimes& times) {
    times.firstPass = drawPass(drawing, options);
    for (int i = 1; i < options.repeats; ++i) {
        const PassTimes again = drawPass(drawing, options);
        if (!times.fastestRepeat || again.total() < times.fastestRepeat->total()) {
            times.fastestRepeat = again;
        }
    }
}

}  // namespace

std::pair<int, int> pictureSize(const scene::Scene& scene, const RenderOptions& options) {
    return {options.width > 0 ? options.width : scene.imageWidth,
            options.height > 0 ? options.height : scene.imageHeight};
}

RenderResult render(gpu::Context& context, const scene::Scene& scene, const RenderOptions& options) {
    const auto [width, height] = pictureSize(scene, options);
    const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    RenderResult result;

    Clock::time_point start = Clock::now();
    const SceneBuffers buffers(context, scene, width, height);
    result.times.scene = secondsSince(start);

    start = Clock::now();
    const PictureTargets targets(context, extent, options.aovs);
    PipelineStore own;
    PictureDrawing drawing(context, options.pipelines != nullptr ? *options.pipelines : own, scene, buffers,
                           targets, extent, {options.route, options.samplesPerSide, options.shaders});
    result.times.pipeline = secondsSince(start);

    drawPasses(drawing, options, result.times);

    start = Clock::now();
    const RouteInfo& output = infoOf(options.route);
    result.picture = targets.readBack(context, extent, output.use, output.layout);
    result.times.readBack = secondsSince(start);
    return result;
}

}  // namespace raytorus::render
