// SPDX-License-Identifier: MIT
// The images of the window: made, lost and made again as the window changes.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <optional>
#include <vector>

#include "gpu/context.hpp"
#include "viewer/window.hpp"

namespace raytorus::viewer {

/// What a frame is recorded into.
struct FrameTarget {
    VkImage image;
    VkFramebuffer framebuffer;  ///< of the image, for Swapchain::renderPass()
    VkExtent2D extent;
};

enum class FrameResult {
    Shown,
    Later,  ///< the window has no size, or its images were made anew: try again
};

class Swapchain {
public:
    /// Both outlive it. Throws Error{NoDevice} if the device cannot draw to this window.
    Swapchain(gpu::Context& context, const Window& window);
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;
    ~Swapchain();

    [[nodiscard]] VkFormat format() const { return surfaceFormat.format; }
    /// Whether the format turns linear values into sRGB by itself.
    [[nodiscard]] bool encodesSrgb() const;

    /// Keeps what is in the image (in VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL before and after) and draws
    /// over it.
    [[nodiscard]] VkRenderPass renderPass() const { return pass.get(); }

    /// Records a frame and shows it. The image comes in VK_IMAGE_LAYOUT_UNDEFINED, usable for copies to it,
    /// and from it where canRead(), and as attachment; `record` leaves it in VK_IMAGE_LAYOUT_PRESENT_SRC_KHR.
    /// The device has finished the frame when this returns.
    FrameResult show(const std::function<void(VkCommandBuffer, const FrameTarget&)>& record);

    /// Whether frames can be copied to the host.
    [[nodiscard]] bool canRead() const { return readable; }

private:
    using Semaphore = gpu::Handle<VkSemaphore, vkDestroySemaphore>;

    struct ImageParts {
        VkImage image = VK_NULL_HANDLE;
        gpu::Handle<VkImageView, vkDestroyImageView> view;
        gpu::Handle<VkFramebuffer, vkDestroyFramebuffer> framebuffer;
        Semaphore finished;  // waited for by the presentation, so free again when the image is
    };

    void makeSurface();
    void dropSurface();
    void chooseFormat();
    void makePass();
    void makeImages();
    // Of an image of the swapchain that is being made.
    [[nodiscard]] ImageParts partsOf(VkImage image) const;
    void dropImages();
    std::optional<std::uint32_t> acquire();
    // Takes note of a result that the window's changes cause. False: it was another failure.
    bool recover(VkResult result);
    [[nodiscard]] Semaphore makeSemaphore() const;

    gpu::Context* context;
    const Window* window;
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkSurfaceFormatKHR surfaceFormat{};
    gpu::Handle<VkRenderPass, vkDestroyRenderPass> pass;
    gpu::Handle<VkSwapchainKHR, vkDestroySwapchainKHR> swapchain;
    VkExtent2D extent{};
    std::vector<ImageParts> images;
    Semaphore acquired;
    bool stale = true;
    bool readable = false;
    int failures = 0;  // to make images or to show one, in a row
};

}  // namespace raytorus::viewer
