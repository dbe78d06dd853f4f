// SPDX-License-Identifier: MIT
// The few commands that every use of the device needs: barriers, drawing a screen, copying out.
#pragma once

#include <vulkan/vulkan.h>

#include <span>

#include "gpu/buffer.hpp"
#include "gpu/device_image.hpp"

namespace raytorus::gpu {

/// Where an image or a buffer is used: the stage and the access.
struct Use {
    VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
};

constexpr Use colorWrite{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                         VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
constexpr Use shaderWrite{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
constexpr Use shaderRead{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
constexpr Use copyRead{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr Use copyWrite{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr Use clearWrite{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr Use blitWrite{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr Use hostRead{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT};

/// Orders `after` behind `before` and changes the layout. From VK_IMAGE_LAYOUT_UNDEFINED the contents are
/// dropped.
void imageBarrier(VkCommandBuffer commands, VkImage image, Use before, VkImageLayout oldLayout, Use after,
                  VkImageLayout newLayout);
void imageBarrier(VkCommandBuffer commands, const DeviceImage& image, Use before, VkImageLayout oldLayout,
                  Use after, VkImageLayout newLayout);

void bufferBarrier(VkCommandBuffer commands, const Buffer& buffer, Use before, Use after);

/// Draws the full-screen triangle of the pipeline in use over `area` of the attachments, which are all of one
/// extent and in VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL. What lies outside `area` is kept.
void drawScreen(VkCommandBuffer commands, std::span<const DeviceImage> attachments, VkRect2D area);

/// Copies the upper left `extent` of an image, which is in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to a buffer:
/// rows from the top, no gaps.
void copyOut(VkCommandBuffer commands, VkImage image, VkExtent2D extent, const Buffer& buffer);
void copyOut(VkCommandBuffer commands, const DeviceImage& image, VkExtent2D extent, const Buffer& buffer);

/// Copies such rows from a buffer to the upper left of an image, which is in
/// VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL.
void copyIn(VkCommandBuffer commands, const Buffer& buffer, const DeviceImage& image, VkExtent2D extent);

}  // namespace raytorus::gpu
