// SPDX-License-Identifier: MIT
#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "gpu/pipeline.hpp"
#include "gpu/timestamps.hpp"
#include "render/picture_targets.hpp"
#include "render/scene_buffers.hpp"

namespace raytorus::render {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// What the two routes differ in.
struct RoutePlan {
    gpu::Use write;
    VkImageLayout layout;
    gpu::Pipeline* pipeline = nullptr;
    std::function<void(VkCommandBuffer, std::uint32_t firstRow, std::uint32_t endRow)> draw;
};

gpu::PipelineLayoutInfo layoutInfo(const Scene& scene, const RenderOptions& options) {
    gpu::PipelineLayoutInfo info;
    info.bindings = sceneBindings();
    info.specialization = {options.aovs ? 1U : 0U, static_cast<std::uint32_t>(options.samplesPerSide),
                           static_cast<std::uint32_t>(scene.lights.size()),
                           static_cast<std::uint32_t>(scene.tori.size()),
                           static_cast<std::uint32_t>(storageFor(scene))};
    return info;
}

gpu::ShaderModule shader(const gpu::Context& context, const RenderOptions& options, const std::string& name) {
    return {context, options.shaders.load(name), name};
}

gpu::Pipeline fragmentPipeline(const gpu::Context& context, const Scene& scene, const RenderOptions& options,
                               std::uint32_t attachments) {
    gpu::PipelineLayoutInfo info = layoutInfo(scene, options);
    info.stages = VK_SHADER_STAGE_FRAGMENT_BIT;
    return gpu::makeScreenPipeline(context, shader(context, options, "fullscreen.vert"),
                                   shader(context, options, "scene.frag"), attachments, info);
}

gpu::Pipeline computePipeline(const gpu::Context& context, const Scene& scene, const RenderOptions& options) {
    gpu::PipelineLayoutInfo info = layoutInfo(scene, options);
    info.pushConstantBytes = 3 * sizeof(std::uint32_t);
    for (std::uint32_t i = 0; i < 4; ++i) {
        info.bindings.push_back({SCENE_BINDING_COLOR + i, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
    }
    return gpu::makeComputePipeline(context, shader(context, options, "scene.comp"), info);
}

RoutePlan makePlan(const gpu::Context& context, const Scene& scene, const RenderOptions& options,
                   const PictureTargets& targets, PipelineStore& store) {
    const std::vector<std::uint32_t> specialization = layoutInfo(scene, options).specialization;
    const std::span<const gpu::Image> images = targets.images();
    const VkExtent2D extent = images.front().extent();
    RoutePlan plan{};
    if (options.route == Route::Fragment) {
        plan.write = gpu::colorWrite;
        plan.layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        plan.pipeline = &store.find(options.route, specialization, [&] {
            return fragmentPipeline(context, scene, options, static_cast<std::uint32_t>(images.size()));
        });
        plan.draw = [images, extent](VkCommandBuffer commands, std::uint32_t firstRow, std::uint32_t endRow) {
            gpu::drawScreen(commands, images,
                            {{0, static_cast<std::int32_t>(firstRow)}, {extent.width, endRow - firstRow}});
        };
        return plan;
    }
    plan.write = gpu::shaderWrite;
    plan.layout = VK_IMAGE_LAYOUT_GENERAL;
    plan.pipeline =
        &store.find(options.route, specialization, [&] { return computePipeline(context, scene, options); });
    for (std::uint32_t i = 0; i < 4; ++i) {
        // Without the geometric pictures the shader never stores to their bindings, but each must be valid.
        plan.pipeline->bind(SCENE_BINDING_COLOR + i, images[std::min<std::size_t>(i, images.size() - 1)]);
    }
    plan.draw = [extent](VkCommandBuffer commands, std::uint32_t firstRow, std::uint32_t endRow) {
        const auto groups = [](std::uint32_t size, std::uint32_t group) {
            return (size + group - 1) / group;
        };
        vkCmdDispatch(commands, groups(extent.width, SCENE_GROUP_WIDTH),
                      groups(endRow - firstRow, SCENE_GROUP_HEIGHT), 1);
    };
    return plan;
}

// Rows are rendered in bands, so that no submission runs long: a GPU's watchdog ends those, and progress is
// seen. The bands are as high as took about this long at the speed of the one before.
constexpr double bandSeconds = 0.25;
constexpr std::uint32_t bandRowUnit = 64;  // lavapipe's tiles are 64 x 64 pixels
constexpr std::uint32_t firstBandPixels = 65536;

std::uint32_t firstBandRows(VkExtent2D extent) {
    return std::clamp<std::uint32_t>(firstBandPixels / extent.width, 1, bandRowUnit);
}

std::uint32_t nextBandRows(std::uint32_t rows, double seconds) {
    const double fitting = rows * std::clamp(bandSeconds / std::max(seconds, 1e-6), 0.25, 16.0);
    const auto whole = static_cast<std::uint32_t>(fitting);
    return whole >= bandRowUnit ? whole / bandRowUnit * bandRowUnit : std::max(whole, 1U);
}

PassTimes renderPass(gpu::Context& context, const RenderOptions& options, const PictureTargets& targets,
                     const RoutePlan& plan, std::uint32_t& rows) {
    const VkExtent2D extent = targets.images().front().extent();
    const gpu::Timestamps timestamps(context);
    PassTimes times;
    for (std::uint32_t row = 0; row < extent.height;) {
        const std::uint32_t end = std::min(row + rows, extent.height);
        const Clock::time_point start = Clock::now();
        context.submit([&](VkCommandBuffer commands) {
            if (row == 0) {
                targets.begin(commands, plan.write, plan.layout);
            }
            timestamps.begin(commands);
            const std::array band = {row, end, extent.width};
            const bool compute = options.route == Route::Compute;
            plan.pipeline->use(commands,
                               compute ? std::as_bytes(std::span(band)) : std::span<const std::byte>());
            plan.draw(commands, row, end);
            timestamps.end(commands);
        });
        const double seconds = secondsSince(start);
        (row == 0 ? times.firstBand : times.otherBands) += seconds;
        (row == 0 ? times.firstPixels : times.otherPixels) += std::int64_t{extent.width} * (end - row);
        times.deviceOtherBands += row == 0 ? 0.0 : timestamps.seconds().value_or(0.0);
        rows = nextBandRows(end - row, seconds);
        row = end;
        if (options.progress) {
            options.progress(static_cast<double>(row) / extent.height);
        }
    }
    return times;
}

void renderPasses(gpu::Context& context, const RenderOptions& options, const PictureTargets& targets,
                  const RoutePlan& plan, RenderTimes& times) {
    std::uint32_t rows = firstBandRows(targets.images().front().extent());
    times.firstPass = renderPass(context, options, targets, plan, rows);
    for (int i = 1; i < options.repeats; ++i) {
        const PassTimes again = renderPass(context, options, targets, plan, rows);
        if (!times.fastestRepeat || again.total() < times.fastestRepeat->total()) {
            times.fastestRepeat = again;
        }
    }
}

}  // namespace

std::pair<int, int> pictureSize(const Scene& scene, const RenderOptions& options) {
    return {options.width > 0 ? options.width : scene.imageWidth,
            options.height > 0 ? options.height : scene.imageHeight};
}

gpu::Pipeline& PipelineStore::find(Route route, const std::vector<std::uint32_t>& specialization,
                                   const std::function<gpu::Pipeline()>& make) {
    const std::pair key(route, specialization);
    auto found = pipelines.find(key);
    if (found == pipelines.end()) {
        found = pipelines.emplace(key, make()).first;
    }
    return found->second;
}

RenderResult render(gpu::Context& context, const Scene& scene, const RenderOptions& options) {
    const auto [width, height] = pictureSize(scene, options);
    const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    RenderResult result;

    Clock::time_point start = Clock::now();
    const SceneBuffers buffers(context, scene, width, height);
    result.times.scene = secondsSince(start);

    start = Clock::now();
    const PictureTargets targets(context, extent, options.aovs);
    PipelineStore own;
    const RoutePlan plan =
        makePlan(context, scene, options, targets, options.pipelines != nullptr ? *options.pipelines : own);
    buffers.bindTo(*plan.pipeline);
    result.times.pipeline = secondsSince(start);

    renderPasses(context, options, targets, plan, result.times);

    start = Clock::now();
    result.picture = targets.readBack(context, plan.write, plan.layout);
    result.times.readBack = secondsSince(start);
    return result;
}

}  // namespace raytorus::render
