// SPDX-License-Identifier: MIT
#include "render/picture_drawing.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace raytorus::render {
namespace {

using Clock = std::chrono::steady_clock;

gpu::PipelineLayoutInfo layoutInfo(const scene::Scene& scene, const DrawingOptions& options,
                                   std::size_t images) {
    gpu::PipelineLayoutInfo info;
    info.bindings = sceneBindings();
    info.specialization = {images > 1 ? 1U : 0U, static_cast<std::uint32_t>(options.samplesPerSide),
                           static_cast<std::uint32_t>(scene.lights.size()),
                           static_cast<std::uint32_t>(scene.tori.size()),
                           static_cast<std::uint32_t>(storageFor(scene))};
    return info;
}

gpu::ShaderModule shader(const gpu::Context& context, const DrawingOptions& options,
                         const std::string& name) {
    return {context, options.shaders.load(name), name};
}

gpu::Pipeline makePipeline(const gpu::Context& context, const DrawingOptions& options,
                           gpu::PipelineLayoutInfo info, std::size_t images) {
    if (options.route == Route::Fragment) {
        info.stages = VK_SHADER_STAGE_FRAGMENT_BIT;
        return gpu::makeScreenPipeline(context, shader(context, options, "fullscreen.vert"),
                                       shader(context, options, "scene.frag"),
                                       static_cast<std::uint32_t>(images), info);
    }
    info.pushConstantBytes = 3 * sizeof(std::uint32_t);
    for (std::uint32_t i = 0; i < 4; ++i) {
        info.bindings.push_back({SCENE_BINDING_COLOR + i, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
    }
    return gpu::makeComputePipeline(context, shader(context, options, "scene.comp"), info);
}

constexpr std::uint32_t bandRowUnit = 64;  // lavapipe's tiles are 64 x 64 pixels
constexpr std::uint32_t firstBandPixels = 65536;

std::uint32_t firstBandRows(VkExtent2D extent) {
    return std::clamp<std::uint32_t>(firstBandPixels / extent.width, 1, bandRowUnit);
}

std::uint32_t nextBandRows(std::uint32_t rows, double seconds, double wanted) {
    const double fitting = rows * std::clamp(wanted / std::max(seconds, 1e-6), 0.25, 16.0);
    const auto whole = static_cast<std::uint32_t>(fitting);
    return whole >= bandRowUnit ? whole / bandRowUnit * bandRowUnit : std::max(whole, 1U);
}

}  // namespace

void preparePipeline(const gpu::Context& context, PipelineStore& pipelines, const scene::Scene& scene,
                     const DrawingOptions& options, bool aovs) {
    const std::size_t images = PictureTargets::imageCount(aovs);
    const gpu::PipelineLayoutInfo info = layoutInfo(scene, options, images);
    pipelines.prepare(options.route, info.specialization,
                      [=, &context] { return makePipeline(context, options, info, images); });
}

RouteOutput outputOf(Route route) {
    return route == Route::Fragment ? RouteOutput{gpu::colorWrite, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}
                                    : RouteOutput{gpu::shaderWrite, VK_IMAGE_LAYOUT_GENERAL};
}

PictureDrawing::PictureDrawing(gpu::Context& gpuContext, PipelineStore& pipelines, const scene::Scene& scene,
                               const SceneBuffers& buffers, const PictureTargets& pictureTargets,
                               VkExtent2D extent, const DrawingOptions& options)
    : context(&gpuContext),
      targets(&pictureTargets),
      pictureExtent(extent),
      route(options.route),
      timestamps(gpuContext),
      rows(firstBandRows(extent)) {
    const std::span<const gpu::Image> images = targets->images();
    const gpu::PipelineLayoutInfo info = layoutInfo(scene, options, images.size());
    pipeline = &pipelines.find(route, info.specialization,
                               [&] { return makePipeline(*context, options, info, images.size()); });
    buffers.bindTo(*pipeline);
    for (std::uint32_t i = 0; route == Route::Compute && i < 4; ++i) {
        // Without the geometric pictures the shader never stores to their bindings, but each must be valid.
        pipeline->bind(SCENE_BINDING_COLOR + i, images[std::min<std::size_t>(i, images.size() - 1)]);
    }
}

void PictureDrawing::draw(VkCommandBuffer commands, std::uint32_t endRow) const {
    const std::array band = {row, endRow, pictureExtent.width};
    if (route == Route::Fragment) {
        pipeline->use(commands);
        gpu::drawScreen(commands, targets->images(),
                        {{0, static_cast<std::int32_t>(row)}, {pictureExtent.width, endRow - row}});
        return;
    }
    pipeline->use(commands, std::as_bytes(std::span(band)));
    const auto groups = [](std::uint32_t size, std::uint32_t group) { return (size + group - 1) / group; };
    vkCmdDispatch(commands, groups(pictureExtent.width, SCENE_GROUP_WIDTH),
                  groups(endRow - row, SCENE_GROUP_HEIGHT), 1);
}

Band PictureDrawing::drawBand(double seconds) {
    Band band;
    band.firstRow = row;
    band.endRow = std::min(row + rows, pictureExtent.height);
    const Clock::time_point start = Clock::now();
    context->submit([&](VkCommandBuffer commands) {
        if (row == 0) {
            const RouteOutput output = outputOf(route);
            targets->begin(commands, output.use, output.layout);
        }
        timestamps.begin(commands);
        draw(commands, band.endRow);
        timestamps.end(commands);
    });
    band.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    band.deviceSeconds = timestamps.seconds().value_or(0.0);
    rows = nextBandRows(band.endRow - row, band.seconds, seconds);
    row = band.endRow;
    return band;
}

}  // namespace raytorus::render
