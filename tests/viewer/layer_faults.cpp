// SPDX-License-Identifier: MIT
// A Vulkan layer for tests: what displays and devices do once in a while, done on time. RAYTORUS_FAULTS has
// the schedule (layer_schedule.hpp) and RAYTORUS_FAULT_LOG the file of what has struck.
//
//   acquire, present   out-of-date, surface-lost, suboptimal, device-lost
//   swapchain          out-of-date, surface-lost, out-of-memory, device-lost
//   submit             device-lost, out-of-memory
//   formats            none (that can be used), srgb (those alone that encode)
//   capabilities       zero (the window has no size), surface-lost
//
// It knows one instance and one device at a time, as the programs have that it is for.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "layer_schedule.hpp"

namespace raytorus::test {
namespace {

FaultSchedule& schedule() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value != nullptr ? value : "");
    };
    static FaultSchedule instance(variable("RAYTORUS_FAULTS"), variable("RAYTORUS_FAULT_LOG"));
    return instance;
}

struct Next {
    VkInstance instance = VK_NULL_HANDLE;
    PFN_vkGetInstanceProcAddr instanceAddress = nullptr;
    PFN_vkGetDeviceProcAddr deviceAddress = nullptr;
    PFN_vkAcquireNextImageKHR acquire = nullptr;
    PFN_vkQueuePresentKHR present = nullptr;
    PFN_vkCreateSwapchainKHR createSwapchain = nullptr;
    PFN_vkQueueSubmit2 submit = nullptr;
    PFN_vkGetPhysicalDeviceSurfaceFormatsKHR formats = nullptr;
    PFN_vkGetPhysicalDeviceSurfaceCapabilitiesKHR capabilities = nullptr;
};

Next& next() {
    static Next instance;
    return instance;
}

VkResult resultOf(std::string_view fault) {
    if (fault == "out-of-date") {
        return VK_ERROR_OUT_OF_DATE_KHR;
    }
    if (fault == "surface-lost") {
        return VK_ERROR_SURFACE_LOST_KHR;
    }
    if (fault == "suboptimal") {
        return VK_SUBOPTIMAL_KHR;
    }
    if (fault == "device-lost") {
        return VK_ERROR_DEVICE_LOST;
    }
    if (fault == "out-of-memory") {
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    std::abort();
}

VKAPI_ATTR VkResult VKAPI_CALL acquireNextImage(VkDevice device, VkSwapchainKHR swapchain,
                                                std::uint64_t timeout, VkSemaphore semaphore, VkFence fence,
                                                std::uint32_t* index) {
    const std::string_view fault = schedule().strike("acquire");
    if (!fault.empty() && fault != "suboptimal") {
        return resultOf(fault);
    }
    const VkResult result = next().acquire(device, swapchain, timeout, semaphore, fence, index);
    return result == VK_SUCCESS && !fault.empty() ? VK_SUBOPTIMAL_KHR : result;
}

// Whatever comes of it, the semaphores are waited for: so the call is made, and its result replaced.
VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue queue, const VkPresentInfoKHR* info) {
    const std::string_view fault = schedule().strike("present");
    const VkResult result = next().present(queue, info);
    return fault.empty() ? result : resultOf(fault);
}

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice device, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks* allocator,
                                               VkSwapchainKHR* swapchain) {
    const std::string_view fault = schedule().strike("swapchain");
    return fault.empty() ? next().createSwapchain(device, info, allocator, swapchain) : resultOf(fault);
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* submits,
                                           VkFence fence) {
    const std::string_view fault = schedule().strike("submit");
    return fault.empty() ? next().submit(queue, count, submits, fence) : resultOf(fault);
}

bool encodes(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB ||
           format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceFormats(VkPhysicalDevice device, VkSurfaceKHR surface,
                                              std::uint32_t* count, VkSurfaceFormatKHR* formats) {
    std::uint32_t all = 0;
    next().formats(device, surface, &all, nullptr);
    std::vector<VkSurfaceFormatKHR> offered(all);
    next().formats(device, surface, &all, offered.data());
    const std::string_view fault = schedule().strike("formats");
    if (fault == "srgb") {
        std::erase_if(offered, [](const VkSurfaceFormatKHR& format) { return !encodes(format.format); });
    } else if (fault == "none") {
        offered.assign(1, {VK_FORMAT_R16G16B16A16_SFLOAT, VK_COLOR_SPACE_SRGB_NONLINEAR_KHR});
    }
    if (formats == nullptr) {
        *count = static_cast<std::uint32_t>(offered.size());
        return VK_SUCCESS;
    }
    const std::uint32_t room = *count;
    *count = std::min(room, static_cast<std::uint32_t>(offered.size()));
    std::copy_n(offered.begin(), *count, formats);
    return *count < offered.size() ? VK_INCOMPLETE : VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceCapabilities(VkPhysicalDevice device, VkSurfaceKHR surface,
                                                   VkSurfaceCapabilitiesKHR* capabilities) {
    const std::string_view fault = schedule().strike("capabilities");
    if (!fault.empty() && fault != "zero") {
        return resultOf(fault);
    }
    const VkResult result = next().capabilities(device, surface, capabilities);
    if (result == VK_SUCCESS && fault == "zero") {
        capabilities->currentExtent = {0, 0};
    }
    return result;
}

// The loader's link to the next layer: in the chain of the structure that creates, the one of this function.
template <typename Link>
Link* linkOf(const void* chain, VkStructureType type) {
    auto* link = static_cast<Link*>(const_cast<void*>(chain));
    while (link != nullptr && (link->sType != type || link->function != VK_LAYER_LINK_INFO)) {
        link = static_cast<Link*>(const_cast<void*>(link->pNext));
    }
    return link;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* instance) {
    auto* link =
        linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr address = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(address(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    if (result != VK_SUCCESS) {
        return result;
    }
    next().instance = *instance;
    next().instanceAddress = address;
    next().formats = reinterpret_cast<PFN_vkGetPhysicalDeviceSurfaceFormatsKHR>(
        address(*instance, "vkGetPhysicalDeviceSurfaceFormatsKHR"));
    next().capabilities = reinterpret_cast<PFN_vkGetPhysicalDeviceSurfaceCapabilitiesKHR>(
        address(*instance, "vkGetPhysicalDeviceSurfaceCapabilitiesKHR"));
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr address = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    const PFN_vkGetDeviceProcAddr deviceAddress = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(address(next().instance, "vkCreateDevice"));
    const VkResult result = create(physical, info, allocator, device);
    if (result != VK_SUCCESS) {
        return result;
    }
    const auto find = [&](const char* name) { return deviceAddress(*device, name); };
    next().deviceAddress = deviceAddress;
    next().acquire = reinterpret_cast<PFN_vkAcquireNextImageKHR>(find("vkAcquireNextImageKHR"));
    next().present = reinterpret_cast<PFN_vkQueuePresentKHR>(find("vkQueuePresentKHR"));
    next().createSwapchain = reinterpret_cast<PFN_vkCreateSwapchainKHR>(find("vkCreateSwapchainKHR"));
    next().submit = reinterpret_cast<PFN_vkQueueSubmit2>(find("vkQueueSubmit2"));
    return VK_SUCCESS;
}

PFN_vkVoidFunction ours(const char* name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceAddress(VkDevice device, const char* name) {
    const PFN_vkVoidFunction own = ours(name);
    return own != nullptr ? own : next().deviceAddress(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceAddress(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction own = ours(name);
    return own != nullptr || instance == VK_NULL_HANDLE ? own : next().instanceAddress(instance, name);
}

PFN_vkVoidFunction ours(const char* name) {
    const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
    const auto pointer = [](auto* function) { return reinterpret_cast<PFN_vkVoidFunction>(function); };
    return is("vkGetInstanceProcAddr")                       ? pointer(&instanceAddress)
           : is("vkGetDeviceProcAddr")                       ? pointer(&deviceAddress)
           : is("vkCreateInstance")                          ? pointer(&createInstance)
           : is("vkCreateDevice")                            ? pointer(&createDevice)
           : is("vkAcquireNextImageKHR")                     ? pointer(&acquireNextImage)
           : is("vkQueuePresentKHR")                         ? pointer(&queuePresent)
           : is("vkCreateSwapchainKHR")                      ? pointer(&createSwapchain)
           : is("vkQueueSubmit2")                            ? pointer(&queueSubmit)
           : is("vkGetPhysicalDeviceSurfaceFormatsKHR")      ? pointer(&surfaceFormats)
           : is("vkGetPhysicalDeviceSurfaceCapabilitiesKHR") ? pointer(&surfaceCapabilities)
                                                             : nullptr;
}

}  // namespace
}  // namespace raytorus::test

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = &raytorus::test::instanceAddress;
    version->pfnGetDeviceProcAddr = &raytorus::test::deviceAddress;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
