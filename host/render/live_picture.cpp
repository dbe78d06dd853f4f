// SPDX-License-Identifier: MIT
#include "render/live_picture.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace raytorus::render {
namespace {

// A band is a share of the time there is, so that little is over when the last one ends.
constexpr double bandsInTime = 3.0;

void makeReadable(gpu::Context& context, const PictureTargets& targets, gpu::Use before,
                  VkImageLayout layout) {
    context.submit([&](VkCommandBuffer commands) {
        for (const gpu::DeviceImage& image : targets.images()) {
            gpu::imageBarrier(commands, image, before, layout, gpu::shaderRead, VK_IMAGE_LAYOUT_GENERAL);
        }
    });
}

}  // namespace

LivePicture::Images::Images(gpu::Context& context, VkExtent2D extent)
    : all(context, extent, true), color(context, extent, false) {
    makeReadable(context, all, {}, VK_IMAGE_LAYOUT_UNDEFINED);
    makeReadable(context, color, {}, VK_IMAGE_LAYOUT_UNDEFINED);
}

LivePicture::LivePicture(gpu::Context& gpuContext, VkExtent2D largest) : context(&gpuContext) {
    resize(largest);
}

void LivePicture::resize(VkExtent2D largest) {
    current.reset();
    images.reset();  // before the new ones, so that both need not fit
    images = std::make_unique<Images>(*context, largest);
}

void LivePicture::setShaders(const scene::Scene& scene, const trace::ShaderSource& newShaders,
                             Route newRoute) {
    PipelineStore store;
    const SceneBuffers probe(*context, scene, 1, 1);
    const PictureDrawing attempt(*context, store, scene, probe, images->all, {1, 1},
                                 {newRoute, 1, newShaders});
    abandon();
    pipelines = std::move(store);
    shaders = newShaders;
    route = newRoute;
    untried = true;
}

const PictureTargets& LivePicture::targetsOf(const LiveRequest& wanted) const {
    return wanted.aovs ? images->all : images->color;
}

void LivePicture::abandon() {
    if (current) {
        current.reset();
        // What was begun is in the layout of the route, or of nothing yet.
        makeReadable(*context, targetsOf(request), {}, VK_IMAGE_LAYOUT_UNDEFINED);
    }
}

void LivePicture::begin(const scene::Scene& scene, const LiveRequest& wanted, bool sameTori) {
    abandon();
    const auto width = static_cast<int>(wanted.extent.width);
    const auto height = static_cast<int>(wanted.extent.height);
    if (buffers && sameTori) {
        buffers->setFrame(scene, width, height);
    } else {
        buffers = std::make_unique<SceneBuffers>(*context, scene, width, height);
    }
    const bool sameCost = bandRows > 0 && wanted.extent.width == request.extent.width &&
                          wanted.samplesPerSide == request.samplesPerSide && wanted.aovs == request.aovs;
    request = wanted;
    const std::size_t known = pipelines.size();
    current.emplace(*context, pipelines, scene, *buffers, targetsOf(request), request.extent,
                    DrawingOptions{route, request.samplesPerSide, shaders});
    if (sameCost) {
        current->setBandRows(bandRows);
    }
    drawTimes = {};
    drawTimes.compiled = std::exchange(untried, false) || pipelines.size() > known;
}

bool LivePicture::draw(double seconds) {
    double spent = 0.0;
    while (current && !current->complete() && spent < seconds) {
        const Band band = current->drawBand(seconds / bandsInTime);
        spent += band.seconds;
        drawTimes.seconds += band.seconds;
        drawTimes.deviceSeconds += band.deviceSeconds;
    }
    if (!current || !current->complete()) {
        return false;
    }
    bandRows = current->bandRows();
    current.reset();
    const RouteInfo& output = infoOf(route);
    makeReadable(*context, targetsOf(request), output.use, output.layout);
    colorAlone = !request.aovs;
    lastTimes = drawTimes;
    return true;
}

const gpu::DeviceImage& LivePicture::image(std::size_t index) const {
    return index == 0 && colorAlone ? images->color.images().front() : images->all.images()[index];
}

image::Image LivePicture::readBack(const PictureTargets& targets, VkExtent2D extent) {
    image::Image picture = targets.readBack(*context, extent, gpu::shaderRead, VK_IMAGE_LAYOUT_GENERAL);
    makeReadable(*context, targets, gpu::copyRead, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    return picture;
}

image::Image LivePicture::readBack(VkExtent2D extent) {
    image::Image picture = readBack(images->all, extent);
    if (!colorAlone) {
        return picture;
    }
    const image::Image color = readBack(images->color, extent);
    const auto channels = static_cast<std::size_t>(picture.channelCount());
    for (std::size_t i = 0; i < color.pixels.size(); ++i) {
        picture.pixels[i / 4 * channels + i % 4] = color.pixels[i];
    }
    return picture;
}

}  // namespace raytorus::render
