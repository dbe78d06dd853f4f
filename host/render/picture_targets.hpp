// SPDX-License-Identifier: MIT
// The device images of a picture, and their way into an image::Image with named channels.
#pragma once

#include <vector>

#include "gpu/commands.hpp"
#include "image/image.hpp"

namespace raytorus::render {

/// One image (colour), or four with the geometric pictures (AOVs), in the order of ScenePixel in shade.glsl.
class PictureTargets {
public:
    PictureTargets(const gpu::Context& context, VkExtent2D extent, bool aovs);

    [[nodiscard]] static std::size_t imageCount(bool aovs);

    [[nodiscard]] std::span<const gpu::DeviceImage> images() const { return targets; }

    /// Makes them ready to be drawn to or stored into, their contents undefined.
    void begin(VkCommandBuffer commands, gpu::Use use, VkImageLayout layout) const;

    /// Copies their upper left `extent` to the host after `use` and leaves them in
    /// VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL. Channels: colour and alpha, and with the geometric pictures all
    /// values that image/channels.hpp lists.
    [[nodiscard]] image::Image readBack(gpu::Context& context, VkExtent2D extent, gpu::Use use,
                                        VkImageLayout layout) const;

private:
    std::vector<gpu::DeviceImage> targets;
};

}  // namespace raytorus::render
