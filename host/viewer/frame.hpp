// SPDX-License-Identifier: MIT
// The frames of the window: the view, enlarged to the window, and the panels over it.
#pragma once

#include <vulkan/vulkan.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "gpu/context.hpp"
#include "gpu/device_image.hpp"
#include "image/image.hpp"
#include "viewer/gui.hpp"
#include "viewer/swapchain.hpp"

namespace raytorus::viewer {

/// Frames that are shown after an input, until ImGui has settled.
inline constexpr int settlingFrames = 3;

/// Where in the window a picture of this size is seen: the largest rectangle of its shape, in the middle.
/// A picture of the window's size is seen unchanged.
VkRect2D placeOf(VkExtent2D picture, VkExtent2D window);

struct FramePicture {
    /// In VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL; null: the frame is dark.
    const gpu::DeviceImage* image = nullptr;
    VkExtent2D extent{};  ///< its upper left part that is seen
    /// Fills the window, smoothly: a picture made small for speed. Else each pixel is a square, see placeOf.
    bool fills = false;
};

/// Shows frames on a window, as many as have to be.
class WindowFrames {
public:
    /// Both outlive it.
    WindowFrames(gpu::Context& context, const Window& window);

    /// Something of what is seen is another: at least so many frames are to be shown.
    void need(int frames = settlingFrames) { missing = std::max(missing, frames); }
    [[nodiscard]] bool needed() const { return missing > 0; }

    /// The last frame was not taken by the window.
    [[nodiscard]] bool late() const { return notTaken; }

    /// Shows a frame. drawPanels: calls ImGui. False: the window did not take it. contents: if not null, the
    /// frame as it is displayed (R, G, B in [0, 1]), or nothing where windows cannot be read back.
    bool show(const FramePicture& picture, const std::function<void()>& drawPanels,
              std::optional<image::Image>* contents);

    [[nodiscard]] Gui& panels() { return gui; }
    [[nodiscard]] const Gui& panels() const { return gui; }

    /// Whether the window turns linear values into sRGB by itself.
    [[nodiscard]] bool encodesSrgb() const { return swapchain.encodesSrgb(); }

private:
    gpu::Context* context;
    Swapchain swapchain;
    Gui gui;
    int missing = settlingFrames;
    bool notTaken = false;
};

}  // namespace raytorus::viewer
