// SPDX-License-Identifier: MIT
// Two-dimensional float images on the device, which shaders render or store into.
#pragma once

#include <vulkan/vulkan.h>

#include "gpu/context.hpp"

namespace raytorus::gpu {

class DeviceImage {
public:
    static constexpr VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    static constexpr VkDeviceSize bytesPerPixel = 16;

    DeviceImage() = default;
    /// Usable as colour attachment, as storage image, and for copies and clears. Its contents start
    /// undefined.
    DeviceImage(const Context& context, VkExtent2D extent);

    [[nodiscard]] VkImage get() const { return image.get(); }
    [[nodiscard]] VkImageView view() const { return imageView.get(); }
    [[nodiscard]] VkExtent2D extent() const { return imageExtent; }

private:
    // Declared in this order so that the view goes before the image, and the image before its memory.
    Handle<VkDeviceMemory, vkFreeMemory> memory;
    Handle<VkImage, vkDestroyImage> image;
    Handle<VkImageView, vkDestroyImageView> imageView;
    VkExtent2D imageExtent{};
};

}  // namespace raytorus::gpu
