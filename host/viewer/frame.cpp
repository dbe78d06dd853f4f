// SPDX-License-Identifier: MIT
#include "viewer/frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"

namespace raytorus::viewer {
namespace {

constexpr VkImageSubresourceRange wholeImage{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

void blit(VkCommandBuffer commands, const FramePicture& picture, const FrameTarget& target) {
    const VkRect2D place =
        picture.fills ? VkRect2D{{0, 0}, target.extent} : placeOf(picture.extent, target.extent);
    VkImageBlit region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<std::int32_t>(picture.extent.width),
                            static_cast<std::int32_t>(picture.extent.height), 1};
    region.dstSubresource = region.srcSubresource;
    region.dstOffsets[0] = {place.offset.x, place.offset.y, 0};
    region.dstOffsets[1] = {place.offset.x + static_cast<std::int32_t>(place.extent.width),
                            place.offset.y + static_cast<std::int32_t>(place.extent.height), 1};
    vkCmdBlitImage(commands, picture.image->get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region,
                   picture.fills ? VK_FILTER_LINEAR : VK_FILTER_NEAREST);
}

// A copy of a frame as it is shown, panels and all.
class FrameCopy {
public:
    FrameCopy(const gpu::Context& context, VkExtent2D size)
        : extent(size),
          buffer(context, VkDeviceSize{4} * size.width * size.height, gpu::BufferUse::ReadBack) {}

    void record(VkCommandBuffer commands, VkImage image) const {
        gpu::copyOut(commands, image, extent, buffer);
    }

    // R, G, B as displayed, in [0, 1].
    [[nodiscard]] image::Image picture(VkFormat format) const {
        const bool blueFirst = format == VK_FORMAT_B8G8R8A8_UNORM || format == VK_FORMAT_B8G8R8A8_SRGB;
        image::Image result(static_cast<int>(extent.width), static_cast<int>(extent.height), {"R", "G", "B"});
        const std::span<const std::uint8_t> bytes = buffer.as<const std::uint8_t>();
        for (std::size_t i = 0; i < result.pixels.size() / 3; ++i) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const std::size_t from = blueFirst ? 2 - channel : channel;
                result.pixels[3 * i + channel] = static_cast<float>(bytes[4 * i + from]) / 255.0F;
            }
        }
        return result;
    }

private:
    VkExtent2D extent;
    gpu::Buffer buffer;
};

// drawOver: draws in VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL. copy may be null.
void recordFrame(VkCommandBuffer commands, const FrameTarget& target, const FramePicture& picture,
                 const std::function<void()>& drawOver, const FrameCopy* copy) {
    constexpr gpu::Use window{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE};
    constexpr gpu::Use transfers{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    constexpr gpu::Use panels{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
    gpu::imageBarrier(commands, target.image, window, VK_IMAGE_LAYOUT_UNDEFINED, gpu::clearWrite,
                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearColorValue dark{{0.03F, 0.03F, 0.035F, 1.0F}};
    vkCmdClearColorImage(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark, 1, &wholeImage);
    if (picture.image != nullptr) {
        gpu::imageBarrier(commands, target.image, gpu::clearWrite, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                          gpu::blitWrite, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        blit(commands, picture, target);
    }
    gpu::imageBarrier(commands, target.image, transfers, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, panels,
                      VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    drawOver();
    gpu::Use last = gpu::colorWrite;
    VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    if (copy != nullptr) {
        gpu::imageBarrier(commands, target.image, last, layout, gpu::copyRead,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        copy->record(commands, target.image);
        last = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_NONE};
        layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    }
    gpu::imageBarrier(commands, target.image, last, layout, window, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
}

}  // namespace

VkRect2D placeOf(VkExtent2D picture, VkExtent2D window) {
    const double scale = std::min(static_cast<double>(window.width) / picture.width,
                                  static_cast<double>(window.height) / picture.height);
    const auto side = [scale](std::uint32_t pixels, std::uint32_t most) {
        return std::clamp(static_cast<std::uint32_t>(std::lround(scale * pixels)), 1U, most);
    };
    const VkExtent2D extent{side(picture.width, window.width), side(picture.height, window.height)};
    return {{static_cast<std::int32_t>((window.width - extent.width) / 2),
             static_cast<std::int32_t>((window.height - extent.height) / 2)},
            extent};
}

WindowFrames::WindowFrames(gpu::Context& gpuContext, const Window& window)
    : context(&gpuContext), swapchain(gpuContext, window), gui(gpuContext, window, swapchain) {}

bool WindowFrames::show(const FramePicture& picture, const std::function<void()>& drawPanels,
                        std::optional<image::Image>* contents) {
    gui.begin();
    drawPanels();
    gui.end();
    std::optional<FrameCopy> copy;
    const FrameResult result = swapchain.show([&](VkCommandBuffer commands, const FrameTarget& target) {
        if (contents != nullptr && swapchain.canRead()) {
            copy.emplace(*context, target.extent);
        }
        recordFrame(
            commands, target, picture, [&] { gui.draw(commands, swapchain.renderPass(), target); },
            copy ? &*copy : nullptr);
    });
    notTaken = result == FrameResult::Later;
    if (notTaken) {
        return false;
    }
    --missing;
    if (copy) {
        *contents = copy->picture(swapchain.format());
    }
    return true;
}

}  // namespace raytorus::viewer
