// SPDX-License-Identifier: MIT
#include "viewer/view_pass.hpp"

#include <algorithm>
#include <array>

#include "gpu/commands.hpp"
#include "image/srgb.hpp"
#include "raytorus_view_shaders.hpp"

namespace raytorus::viewer {
namespace {

gpu::Pipeline makePipeline(const gpu::Context& context) {
    gpu::PipelineLayoutInfo info;
    for (std::uint32_t i = 0; i < VIEW_BINDING_COUNT; ++i) {
        info.bindings.push_back({i, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
    }
    info.pushConstantBytes = sizeof(view_io::ViewPush);
    const gpu::ShaderModule shader(context, view_shaders::find("view.comp"), "view.comp");
    return gpu::makeComputePipeline(context, shader, info);
}

}  // namespace

ViewPass::ViewPass(gpu::Context& gpuContext) : context(&gpuContext), pipeline(makePipeline(gpuContext)) {
    need({1, 1});
}

void ViewPass::need(VkExtent2D extent) {
    const VkExtent2D had = output.extent();
    if (had.width >= extent.width && had.height >= extent.height) {
        return;
    }
    const VkExtent2D size{std::max(had.width, extent.width), std::max(had.height, extent.height)};
    output = gpu::DeviceImage(*context, size);
    analysis = gpu::DeviceImage(*context, size);
    const VkClearColorValue pending{};
    context->submit([&](VkCommandBuffer commands) {
        gpu::imageBarrier(commands, analysis, {}, VK_IMAGE_LAYOUT_UNDEFINED, gpu::clearWrite,
                          VK_IMAGE_LAYOUT_GENERAL);
        const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, analysis.get(), VK_IMAGE_LAYOUT_GENERAL, &pending, 1, &all);
    });
}

void ViewPass::setAnalysis(const AnalysisPixels& pixels) {
    const VkExtent2D extent{static_cast<std::uint32_t>(pixels.width),
                            static_cast<std::uint32_t>(pixels.height)};
    need(extent);
    const gpu::Buffer buffer =
        gpu::makeBuffer(*context, std::span<const float>(pixels.values), gpu::BufferUse::Upload);
    context->submit([&](VkCommandBuffer commands) {
        gpu::imageBarrier(commands, analysis, gpu::shaderRead, VK_IMAGE_LAYOUT_GENERAL, gpu::copyWrite,
                          VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        gpu::copyIn(commands, buffer, analysis, extent);
        gpu::imageBarrier(commands, analysis, gpu::copyWrite, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                          gpu::shaderRead, VK_IMAGE_LAYOUT_GENERAL);
    });
}

void ViewPass::draw(const render::LivePicture& left, const render::LivePicture* right,
                    const view_io::ViewPush& push) {
    const VkExtent2D extent{push.width, push.height};
    need(extent);
    for (std::uint32_t i = 0; i < 4; ++i) {
        pipeline.bind(VIEW_BINDING_LEFT + i, left.image(i));
        pipeline.bind(VIEW_BINDING_RIGHT + i, (right != nullptr ? *right : left).image(i));
    }
    pipeline.bind(VIEW_BINDING_ANALYSIS, analysis);
    pipeline.bind(VIEW_BINDING_OUTPUT, output);
    context->submit([&](VkCommandBuffer commands) {
        gpu::imageBarrier(commands, output, {}, VK_IMAGE_LAYOUT_UNDEFINED, gpu::shaderWrite,
                          VK_IMAGE_LAYOUT_GENERAL);
        pipeline.use(commands, std::as_bytes(std::span(&push, 1)));
        vkCmdDispatch(commands, (extent.width + VIEW_GROUP - 1) / VIEW_GROUP,
                      (extent.height + VIEW_GROUP - 1) / VIEW_GROUP, 1);
        gpu::imageBarrier(commands, output, gpu::shaderWrite, VK_IMAGE_LAYOUT_GENERAL, gpu::copyRead,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    });
    shownExtent = extent;
    shownLinear = push.linear != 0;
}

image::Image ViewPass::readBack() {
    const std::size_t pixels = std::size_t{shownExtent.width} * shownExtent.height;
    const gpu::Buffer buffer(*context, pixels * gpu::DeviceImage::bytesPerPixel, gpu::BufferUse::ReadBack);
    context->submit([&](VkCommandBuffer commands) {
        gpu::copyOut(commands, output, shownExtent, buffer);
        gpu::bufferBarrier(commands, buffer, gpu::copyWrite, gpu::hostRead);
    });
    image::Image picture(static_cast<int>(shownExtent.width), static_cast<int>(shownExtent.height),
                         {"R", "G", "B"});
    const std::span<const float> values = buffer.as<const float>();
    for (std::size_t i = 0; i < pixels; ++i) {
        std::copy_n(&values[4 * i], 3, &picture.pixels[3 * i]);
    }
    if (shownLinear) {
        for (float& value : picture.pixels) {
            value = static_cast<float>(image::encodeSrgb(value)) / 255.0F;
        }
    }
    return picture;
}

}  // namespace raytorus::viewer
