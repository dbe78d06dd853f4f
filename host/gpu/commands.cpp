// SPDX-License-Identifier: MIT
#include "gpu/commands.hpp"

#include <vector>

namespace raytorus::gpu {

void imageBarrier(VkCommandBuffer commands, VkImage image, Use before, VkImageLayout oldLayout, Use after,
                  VkImageLayout newLayout) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = before.stage;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stage;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = oldLayout;
    barrier.newLayout = newLayout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void imageBarrier(VkCommandBuffer commands, const DeviceImage& image, Use before, VkImageLayout oldLayout,
                  Use after, VkImageLayout newLayout) {
    imageBarrier(commands, image.get(), before, oldLayout, after, newLayout);
}

void bufferBarrier(VkCommandBuffer commands, const Buffer& buffer, Use before, Use after) {
    VkBufferMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
    barrier.srcStageMask = before.stage;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stage;
    barrier.dstAccessMask = after.access;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer.get();
    barrier.size = VK_WHOLE_SIZE;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.bufferMemoryBarrierCount = 1;
    dependency.pBufferMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void drawScreen(VkCommandBuffer commands, std::span<const DeviceImage> attachments, VkRect2D area) {
    std::vector<VkRenderingAttachmentInfo> infos;
    for (const DeviceImage& image : attachments) {
        VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        info.imageView = image.view();
        info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        info.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  // the triangle covers the whole area
        info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        infos.push_back(info);
    }
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    rendering.renderArea = area;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(infos.size());
    rendering.pColorAttachments = infos.data();
    const VkExtent2D extent = attachments.front().extent();
    const VkViewport viewport{0.0F, 0.0F, static_cast<float>(extent.width), static_cast<float>(extent.height),
                              0.0F, 1.0F};
    vkCmdBeginRendering(commands, &rendering);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

namespace {

VkBufferImageCopy upperLeft(VkExtent2D extent) {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    return region;
}

}  // namespace

void copyOut(VkCommandBuffer commands, VkImage image, VkExtent2D extent, const Buffer& buffer) {
    const VkBufferImageCopy region = upperLeft(extent);
    vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.get(), 1, &region);
}

void copyOut(VkCommandBuffer commands, const DeviceImage& image, VkExtent2D extent, const Buffer& buffer) {
    copyOut(commands, image.get(), extent, buffer);
}

void copyIn(VkCommandBuffer commands, const Buffer& buffer, const DeviceImage& image, VkExtent2D extent) {
    const VkBufferImageCopy region = upperLeft(extent);
    vkCmdCopyBufferToImage(commands, buffer.get(), image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
}

}  // namespace raytorus::gpu
