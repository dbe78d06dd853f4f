// SPDX-License-Identifier: MIT
#include "gpu/device_image.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {

DeviceImage::DeviceImage(const Context& context, VkExtent2D extent) : imageExtent(extent) {
    const std::uint32_t limit = context.info().limits.maxImageDimension2D;
    if (extent.width > limit || extent.height > limit) {
        throw Error(ExitCode::OutOfMemory,
                    fmt::format("an image of {}x{} pixels is needed, and {} allows {}x{}", extent.width,
                                extent.height, context.info().name, limit, limit));
    }
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    image = create<vkDestroyImage>(vkCreateImage, context.scope(), info, "vkCreateImage");
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(context.device(), image.get(), &requirements);
    memory = context.allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkBindImageMemory(context.device(), image.get(), memory.get(), 0), "vkBindImageMemory");

    VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = image.get();
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = format;
    viewInfo.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    imageView = create<vkDestroyImageView>(vkCreateImageView, context.scope(), viewInfo, "vkCreateImageView");
}

}  // namespace raytorus::gpu
