// SPDX-License-Identifier: MIT
// What a frame of the window consists of: the view, enlarged to the window, and the panels over it.
#pragma once

#include <vulkan/vulkan.h>

#include "gpu/buffer.hpp"
#include "gpu/context.hpp"
#include "gpu/image.hpp"
#include "image/image.hpp"
#include "viewer/gui.hpp"
#include "viewer/swapchain.hpp"

namespace raytorus::viewer {

/// Where in the window a picture of this size is seen: the largest rectangle of its shape, in the middle.
/// A picture of the window's size is seen unchanged.
VkRect2D placeOf(VkExtent2D picture, VkExtent2D window);

struct FramePicture {
    const gpu::Image* image = nullptr;  ///< in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL; null: the frame is dark
    VkExtent2D extent{};                ///< its upper left part that is seen
    /// Fills the window, smoothly: a picture made small for speed. Else each pixel is a square, see placeOf.
    bool fills = false;
};

/// A copy of a frame as it is shown, panels and all.
class FrameCopy {
public:
    FrameCopy(const gpu::Context& context, VkExtent2D extent);

    void record(VkCommandBuffer commands, VkImage image) const;
    /// R, G, B as displayed, in [0, 1].
    [[nodiscard]] image::Image picture(VkFormat format) const;

private:
    VkExtent2D extent;
    gpu::Buffer buffer;
};

/// Records a frame: `copy` may be null.
void recordFrame(VkCommandBuffer commands, const FrameTarget& target, const FramePicture& picture,
                 const Gui& gui, VkRenderPass pass, const FrameCopy* copy);

}  // namespace raytorus::viewer
