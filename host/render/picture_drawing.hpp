// SPDX-License-Identifier: MIT
// One picture in the making: bands of rows, so that no submission runs long, progress is seen, and a window
// stays alive between two of them.
#pragma once

#include <cstdint>

#include "gpu/timestamps.hpp"
#include "render/picture_targets.hpp"
#include "render/pipeline_store.hpp"
#include "render/scene_buffers.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::render {

/// How a picture is drawn; where the geometric pictures go is the targets' business.
struct DrawingOptions {
    Route route = Route::Fragment;
    int samplesPerSide = 1;
    trace::ShaderSource shaders;
};

/// A band of rows that has been drawn, in seconds.
struct Band {
    std::uint32_t firstRow = 0;
    std::uint32_t endRow = 0;
    double seconds = 0.0;        ///< by the wall clock
    double deviceSeconds = 0.0;  ///< the device's own; 0 where it has no timestamps
};

/// Lets the pipeline that such a drawing needs be made in another thread, for PictureDrawing to find it in
/// the store. aovs: the geometric pictures too. The context is kept by reference.
void preparePipeline(const gpu::Context& context, PipelineStore& pipelines, const scene::Scene& scene,
                     const DrawingOptions& options, bool aovs);

class PictureDrawing {
public:
    /// Draws into the upper left `extent` of the targets. Everything is kept by reference but the options,
    /// and lives as long as the drawing.
    PictureDrawing(gpu::Context& context, PipelineStore& pipelines, const scene::Scene& scene,
                   const SceneBuffers& buffers, const PictureTargets& targets, VkExtent2D extent,
                   const DrawingOptions& options);

    /// The next rows, as many as took about `seconds` at the speed of the band before.
    Band drawBand(double seconds);

    [[nodiscard]] bool complete() const { return row == pictureExtent.height; }
    [[nodiscard]] VkExtent2D extent() const { return pictureExtent; }

    /// From the first row again, with the speed that is known by now.
    void restart() { row = 0; }

    /// The rows of the next band: how fast this drawing is by now, for the next one of the same size.
    [[nodiscard]] std::uint32_t bandRows() const { return rows; }
    void setBandRows(std::uint32_t count) { rows = count; }

private:
    void draw(VkCommandBuffer commands, std::uint32_t endRow) const;

    gpu::Context* context;
    const PictureTargets* targets;
    VkExtent2D pictureExtent;
    Route route;
    gpu::Pipeline* pipeline;
    gpu::Timestamps timestamps;
    std::uint32_t rows;
    std::uint32_t row = 0;
};

}  // namespace raytorus::render
