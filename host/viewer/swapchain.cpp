// SPDX-License-Identifier: MIT
#include "viewer/swapchain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::viewer {
namespace {

using gpu::check;

// A window that is being dragged makes its images stale again and again; one that stays so is broken.
constexpr int mostFailures = 100;

template <typename Item, typename Function, typename... Arguments>
std::vector<Item> enumerate(const char* call, Function function, Arguments... arguments) {
    std::uint32_t count = 0;
    check(function(arguments..., &count, nullptr), call);
    std::vector<Item> items(count);
    const VkResult result = function(arguments..., &count, items.data());
    items.resize(count);
    check(result == VK_INCOMPLETE ? VK_SUCCESS : result, call);
    return items;
}

}  // namespace

Swapchain::Swapchain(gpu::Context& gpuContext, const Window& shownWindow)
    : context(&gpuContext), window(&shownWindow) {
    try {
        makeSurface();
        chooseFormat();
        makePass();
        acquired = makeSemaphore();
    } catch (...) {
        dropSurface();  // a constructor that throws runs no destructor
        throw;
    }
}

Swapchain::~Swapchain() {
    dropImages();
    swapchain = {};
    dropSurface();
}

Swapchain::Semaphore Swapchain::makeSemaphore() const {
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, nullptr, 0};
    return gpu::create<vkDestroySemaphore>(vkCreateSemaphore, context->scope(), info, "vkCreateSemaphore");
}

void Swapchain::makeSurface() {
    surface = window->makeSurface(context->instance());
    VkBool32 supported = VK_FALSE;
    check(vkGetPhysicalDeviceSurfaceSupportKHR(context->info().handle, context->info().queueFamily, surface,
                                               &supported),
          "vkGetPhysicalDeviceSurfaceSupportKHR");
    if (supported == VK_FALSE) {
        throw Error(
            ExitCode::NoDevice,
            fmt::format(
                "{} cannot draw to this display's windows: choose another device by --device (raytorus "
                "doctor lists them)",
                context->info().name));
    }
}

void Swapchain::dropSurface() {
    if (surface != VK_NULL_HANDLE && !context->scope().abandoned) {
        vkDestroySurfaceKHR(context->instance(), surface, nullptr);
    }
    surface = VK_NULL_HANDLE;
}

// Eight bits a channel, and best without an encoding of its own: the views come encoded.
void Swapchain::chooseFormat() {
    const auto formats =
        enumerate<VkSurfaceFormatKHR>("vkGetPhysicalDeviceSurfaceFormatsKHR",
                                      vkGetPhysicalDeviceSurfaceFormatsKHR, context->info().handle, surface);
    constexpr std::array wanted = {VK_FORMAT_B8G8R8A8_UNORM,        VK_FORMAT_R8G8B8A8_UNORM,
                                   VK_FORMAT_A8B8G8R8_UNORM_PACK32, VK_FORMAT_B8G8R8A8_SRGB,
                                   VK_FORMAT_R8G8B8A8_SRGB,         VK_FORMAT_A8B8G8R8_SRGB_PACK32};
    for (const VkFormat format : wanted) {
        const auto found = std::ranges::find_if(formats, [format](const VkSurfaceFormatKHR& offered) {
            return offered.format == format && offered.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
        });
        if (found != formats.end()) {
            surfaceFormat = *found;
            return;
        }
    }
    throw Error(ExitCode::NoDevice,
                fmt::format("{} offers no 8 bit sRGB format for this window (it offers {} others)",
                            context->info().name, formats.size()));
}

bool Swapchain::encodesSrgb() const {
    return surfaceFormat.format == VK_FORMAT_B8G8R8A8_SRGB ||
           surfaceFormat.format == VK_FORMAT_R8G8B8A8_SRGB ||
           surfaceFormat.format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

void Swapchain::makePass() {
    VkAttachmentDescription attachment{};
    attachment.format = surfaceFormat.format;
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    attachment.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    attachment.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 1;
    info.pAttachments = &attachment;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    pass = gpu::create<vkDestroyRenderPass>(vkCreateRenderPass, context->scope(), info, "vkCreateRenderPass");
}

void Swapchain::dropImages() {
    if (!context->scope().abandoned) {
        vkQueueWaitIdle(context->queue());  // the presentations too; a lost device is found out elsewhere
    }
    images.clear();
}

Swapchain::ImageParts Swapchain::partsOf(VkImage image) const {
    ImageParts parts;
    parts.image = image;
    VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = image;
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = surfaceFormat.format;
    viewInfo.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    parts.view =
        gpu::create<vkDestroyImageView>(vkCreateImageView, context->scope(), viewInfo, "vkCreateImageView");
    VkFramebufferCreateInfo bufferInfo{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    bufferInfo.renderPass = pass.get();
    bufferInfo.attachmentCount = 1;
    bufferInfo.pAttachments = parts.view.address();
    bufferInfo.width = extent.width;
    bufferInfo.height = extent.height;
    bufferInfo.layers = 1;
    parts.framebuffer = gpu::create<vkDestroyFramebuffer>(vkCreateFramebuffer, context->scope(), bufferInfo,
                                                          "vkCreateFramebuffer");
    parts.finished = makeSemaphore();
    return parts;
}

void Swapchain::makeImages() {
    dropImages();
    VkSurfaceCapabilitiesKHR capabilities{};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(context->info().handle, surface, &capabilities),
          "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    constexpr VkImageUsageFlags needed =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if ((capabilities.supportedUsageFlags & needed) != needed) {
        throw Error(ExitCode::NoDevice,
                    fmt::format("{} cannot copy pictures to this window", context->info().name));
    }
    readable = (capabilities.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_SRC_BIT) != 0;
    extent = capabilities.currentExtent;
    if (extent.width == 0xFFFFFFFFU) {  // Wayland: the window is as large as its images
        const VkExtent2D size = window->framebufferSize();
        extent.width =
            std::clamp(size.width, capabilities.minImageExtent.width, capabilities.maxImageExtent.width);
        extent.height =
            std::clamp(size.height, capabilities.minImageExtent.height, capabilities.maxImageExtent.height);
    }
    if (extent.width == 0 || extent.height == 0) {
        swapchain = {};
        return;
    }
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface;
    info.minImageCount = capabilities.minImageCount + 1;
    if (capabilities.maxImageCount > 0) {
        info.minImageCount = std::min(info.minImageCount, capabilities.maxImageCount);
    }
    info.imageFormat = surfaceFormat.format;
    info.imageColorSpace = surfaceFormat.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = needed | (readable ? VkImageUsageFlags{VK_IMAGE_USAGE_TRANSFER_SRC_BIT} : 0U);
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = (capabilities.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;  // the one that every device has; nothing tears
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain.get();
    auto fresh = gpu::create<vkDestroySwapchainKHR>(vkCreateSwapchainKHR, context->scope(), info,
                                                    "vkCreateSwapchainKHR");
    swapchain = std::move(fresh);
    for (VkImage image : enumerate<VkImage>("vkGetSwapchainImagesKHR", vkGetSwapchainImagesKHR,
                                            context->device(), swapchain.get())) {
        images.push_back(partsOf(image));
    }
    stale = false;
}

bool Swapchain::recover(VkResult result) {
    const bool windowChanged = result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR;
    if (!windowChanged && result != VK_ERROR_SURFACE_LOST_KHR) {
        return false;
    }
    if (result != VK_SUBOPTIMAL_KHR && ++failures > mostFailures) {
        throw Error(ExitCode::DeviceLost,
                    fmt::format("the window cannot be drawn to: {} on {} attempts in a row",
                                gpu::resultName(result), mostFailures));
    }
    if (result == VK_ERROR_SURFACE_LOST_KHR) {
        dropImages();
        swapchain = {};
        dropSurface();
        makeSurface();
    }
    stale = true;
    return true;
}

std::optional<std::uint32_t> Swapchain::acquire() {
    if (stale || !swapchain) {
        try {
            makeImages();
        } catch (const gpu::ResultError& error) {
            if (!recover(error.result)) {
                throw;
            }
            return std::nullopt;
        }
        if (!swapchain) {
            return std::nullopt;
        }
    }
    std::uint32_t index = 0;
    constexpr std::uint64_t patience = 1'000'000'000;  // a hidden window's images may never come
    const VkResult result = vkAcquireNextImageKHR(context->device(), swapchain.get(), patience,
                                                  acquired.get(), VK_NULL_HANDLE, &index);
    if (result == VK_TIMEOUT || result == VK_NOT_READY) {
        return std::nullopt;
    }
    if (result == VK_SUBOPTIMAL_KHR) {  // the image is there all the same
        stale = true;
        return index;
    }
    if (recover(result)) {
        return std::nullopt;
    }
    check(result, "vkAcquireNextImageKHR");
    return index;
}

FrameResult Swapchain::show(const std::function<void(VkCommandBuffer, const FrameTarget&)>& record) {
    const std::optional<std::uint32_t> index = acquire();
    if (!index) {
        return FrameResult::Later;
    }
    const ImageParts& image = images[*index];
    context->submit(
        [&](VkCommandBuffer commands) {
            record(commands, {image.image, image.framebuffer.get(), extent});
        },
        acquired.get(), image.finished.get());
    VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    present.waitSemaphoreCount = 1;
    present.pWaitSemaphores = image.finished.address();
    present.swapchainCount = 1;
    present.pSwapchains = swapchain.address();
    present.pImageIndices = &*index;
    const VkResult result = vkQueuePresentKHR(context->queue(), &present);
    if (recover(result)) {
        return result == VK_SUBOPTIMAL_KHR ? FrameResult::Shown : FrameResult::Later;
    }
    check(result, "vkQueuePresentKHR");
    failures = 0;
    return FrameResult::Shown;
}

}  // namespace raytorus::viewer
