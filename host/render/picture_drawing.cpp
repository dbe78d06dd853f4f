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

// Some rows of a picture, the images that it is drawn into, and its pipeline.
struct Rows {
    gpu::Pipeline& pipeline;
    std::span<const gpu::DeviceImage> images;
    std::uint32_t first;
    std::uint32_t end;
    std::uint32_t width;
};

gpu::Pipeline makeFragmentPipeline(const gpu::Context& context, const DrawingOptions& options,
                                   gpu::PipelineLayoutInfo info, std::size_t images) {
    info.stages = VK_SHADER_STAGE_FRAGMENT_BIT;
    return gpu::makeScreenPipeline(context, shader(context, options, "fullscreen.vert"),
                                   shader(context, options, "scene.frag"), static_cast<std::uint32_t>(images),
                                   info);
}

// It writes to attachments, which belong to no binding.
void bindNoImages(gpu::Pipeline& /*pipeline*/, std::span<const gpu::DeviceImage> /*images*/) {}

void drawFragments(VkCommandBuffer commands, const Rows& rows) {
    rows.pipeline.use(commands);
    gpu::drawScreen(commands, rows.images,
                    {{0, static_cast<std::int32_t>(rows.first)}, {rows.width, rows.end - rows.first}});
}

constexpr std::uint32_t computeImages = 4;

gpu::Pipeline makeComputePipeline(const gpu::Context& context, const DrawingOptions& options,
                                  gpu::PipelineLayoutInfo info, std::size_t /*images*/) {
    info.pushConstantBytes = 3 * sizeof(std::uint32_t);
    for (std::uint32_t i = 0; i < computeImages; ++i) {
        info.bindings.push_back({SCENE_BINDING_COLOR + i, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
    }
    return gpu::makeComputePipeline(context, shader(context, options, "scene.comp"), info);
}

void bindStorageImages(gpu::Pipeline& pipeline, std::span<const gpu::DeviceImage> images) {
    for (std::uint32_t i = 0; i < computeImages; ++i) {
        // Without the geometric pictures the shader never stores to their bindings, but each must be valid.
        pipeline.bind(SCENE_BINDING_COLOR + i, images[std::min<std::size_t>(i, images.size() - 1)]);
    }
}

void dispatch(VkCommandBuffer commands, const Rows& rows) {
    const std::array constants = {rows.first, rows.end, rows.width};
    rows.pipeline.use(commands, std::as_bytes(std::span(constants)));
    const auto groups = [](std::uint32_t size, std::uint32_t group) { return (size + group - 1) / group; };
    vkCmdDispatch(commands, groups(rows.width, SCENE_GROUP_WIDTH),
                  groups(rows.end - rows.first, SCENE_GROUP_HEIGHT), 1);
}

// How each route draws, in the order of `routes`.
struct RouteWork {
    gpu::Pipeline (*makePipeline)(const gpu::Context&, const DrawingOptions&, gpu::PipelineLayoutInfo,
                                  std::size_t images);
    void (*bindImages)(gpu::Pipeline&, std::span<const gpu::DeviceImage>);
    void (*draw)(VkCommandBuffer, const Rows&);
};
constexpr std::array<RouteWork, routes.size()> work = {{
    {makeFragmentPipeline, bindNoImages, drawFragments},
    {makeComputePipeline, bindStorageImages, dispatch},
}};

const RouteWork& workOf(Route route) {
    return work[static_cast<std::size_t>(route)];
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
    pipelines.prepare(options.route, info.specialization, [=, &context] {
        return workOf(options.route).makePipeline(context, options, info, images);
    });
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
    const std::span<const gpu::DeviceImage> images = targets->images();
    const gpu::PipelineLayoutInfo info = layoutInfo(scene, options, images.size());
    pipeline = &pipelines.find(route, info.specialization, [&] {
        return workOf(route).makePipeline(*context, options, info, images.size());
    });
    buffers.bindTo(*pipeline);
    workOf(route).bindImages(*pipeline, images);
}

void PictureDrawing::draw(VkCommandBuffer commands, std::uint32_t endRow) const {
    workOf(route).draw(commands, {*pipeline, targets->images(), row, endRow, pictureExtent.width});
}

Band PictureDrawing::drawBand(double seconds) {
    Band band;
    band.firstRow = row;
    band.endRow = std::min(row + rows, pictureExtent.height);
    const Clock::time_point start = Clock::now();
    context->submit([&](VkCommandBuffer commands) {
        if (row == 0) {
            const RouteInfo& output = infoOf(route);
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
