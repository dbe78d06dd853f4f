// SPDX-License-Identifier: MIT
#include "gpu/context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "gpu/driver_files.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

VkApplicationInfo applicationInfo() {
    VkApplicationInfo info{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    info.pApplicationName = "raytorus";
    info.apiVersion = VK_API_VERSION_1_3;
    return info;
}

VkInstance makeInstance(const VkInstanceCreateInfo& info) {
    leaveOutDamagedDrivers();
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
        throw Error(ExitCode::NoDevice,
                    "no Vulkan driver was found: install one (Debian: mesa-vulkan-drivers has one that needs "
                    "no GPU), "
                    "or correct VK_DRIVER_FILES / VK_ICD_FILENAMES if you set them");
    }
    check(result, "vkCreateInstance");
    return instance;
}

// The extension; the one feature it has comes with it.
bool offersPipelineStatistics(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
          "vkEnumerateDeviceExtensionProperties");
    std::vector<VkExtensionProperties> extensions(count);
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()),
          "vkEnumerateDeviceExtensionProperties");
    return std::any_of(extensions.begin(), extensions.end(), [](const VkExtensionProperties& extension) {
        return std::string_view(extension.extensionName) ==
               VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    });
}

}  // namespace

Context::Context(const ContextOptions& options, std::shared_ptr<ValidationLog> messageLog)
    : log(std::move(messageLog)), timeoutSeconds(options.timeoutSeconds) {
    try {
        createInstance(options);
        deviceInfo = pickDevice(listDevices(vkInstance, options.deviceExtensions), options.device);
        createDevice(options);
        if (!options.compileOnly) {
            submission.emplace(*this);
        }
    } catch (...) {
        destroy();  // a constructor that throws runs no destructor
        throw;
    }
}

Context::~Context() {
    destroy();
}

void Context::createInstance(const ContextOptions& options) {
    const VkApplicationInfo application = applicationInfo();
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    std::vector<const char*> extensions = options.instanceExtensions;
    if (!options.validate) {
        info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
        info.ppEnabledExtensionNames = extensions.data();
        vkInstance = makeInstance(info);
        return;
    }
    if (!validationLayerAvailable()) {
        throw Error(ExitCode::NoDevice,
                    "validation was asked for, but VK_LAYER_KHRONOS_validation is not installed (Debian: "
                    "vulkan-validationlayers)");
    }
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    VkDebugUtilsMessengerCreateInfoEXT messages = messengerInfo(*log);
    const VkValidationFeatureEnableEXT synchronization =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;
    features.pNext = &messages;
    info.pNext = &features;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validationLayer;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    vkInstance = makeInstance(info);
    const auto createMessenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(vkInstance, "vkCreateDebugUtilsMessengerEXT"));
    check(createMessenger(vkInstance, &messages, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
}

void Context::createDevice(const ContextOptions& options) {
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = deviceInfo.queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan13Features features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    features.dynamicRendering = VK_TRUE;
    features.synchronization2 = VK_TRUE;
    features.maintenance4 = VK_TRUE;  // glslang writes workgroup sizes in the form that needs it
    VkPhysicalDeviceFeatures available{};
    vkGetPhysicalDeviceFeatures(deviceInfo.handle, &available);
    float64 = options.float64 && available.shaderFloat64 == VK_TRUE;
    VkPhysicalDeviceFeatures enabled{};
    enabled.shaderFloat64 = float64 ? VK_TRUE : VK_FALSE;
    std::vector<const char*> extensions = options.deviceExtensions;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
    executables.pipelineExecutableInfo = VK_TRUE;
    pipelineStatistics = options.pipelineStatistics && offersPipelineStatistics(deviceInfo.handle);
    if (pipelineStatistics) {
        extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
        features.pNext = &executables;
    }
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &features;
    info.pEnabledFeatures = &enabled;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    check(vkCreateDevice(deviceInfo.handle, &info, nullptr, &deviceScope.device), "vkCreateDevice");
    vkGetDeviceQueue(deviceScope.device, deviceInfo.queueFamily, 0, &vkQueue);
}

void Context::destroy() noexcept {
    submission.reset();
    if (deviceScope.abandoned) {
        return;
    }
    if (deviceScope.device != VK_NULL_HANDLE) {
        vkDestroyDevice(deviceScope.device, nullptr);
    }
    if (messenger != VK_NULL_HANDLE) {
        const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(vkInstance, "vkDestroyDebugUtilsMessengerEXT"));
        destroyMessenger(vkInstance, messenger, nullptr);
    }
    if (vkInstance != VK_NULL_HANDLE) {
        vkDestroyInstance(vkInstance, nullptr);
    }
}

void Context::submit(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait,
                     VkSemaphore signal) {
    submission->start(record, wait, signal);
    submission->finish();
}

void Context::wait(VkFence fence) {
    const auto nanoseconds = static_cast<std::uint64_t>(std::ceil(timeoutSeconds * 1e9));
    const VkResult waited = vkWaitForFences(device(), 1, &fence, VK_TRUE, nanoseconds);
    if (waited == VK_TIMEOUT) {
        deviceScope.abandoned = true;
        throw Error(ExitCode::DeviceLost, fmt::format("{} did not finish a piece of work within {} s",
                                                      deviceInfo.name, timeoutSeconds));
    }
    check(waited, "vkWaitForFences");
}

Handle<VkDeviceMemory, vkFreeMemory> Context::allocate(const VkMemoryRequirements& requirements,
                                                       VkMemoryPropertyFlags required,
                                                       VkMemoryPropertyFlags wanted) const {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(deviceInfo.handle, &memory);
    for (const VkMemoryPropertyFlags flags : std::array{required | wanted, required}) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const bool allowed = (requirements.memoryTypeBits & (1U << type)) != 0;
            if (!allowed || (memory.memoryTypes[type].propertyFlags & flags) != flags) {
                continue;
            }
            const std::uint64_t heap = memory.memoryHeaps[memory.memoryTypes[type].heapIndex].size;
            if (requirements.size > heap) {
                throw Error(ExitCode::OutOfMemory,
                            fmt::format("{:.1f} GiB of memory are needed in one piece, and {} has {:.1f} GiB",
                                        std::ldexp(static_cast<double>(requirements.size), -30),
                                        deviceInfo.name, std::ldexp(static_cast<double>(heap), -30)));
            }
            VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
            info.allocationSize = requirements.size;
            info.memoryTypeIndex = type;
            return create<vkFreeMemory>(vkAllocateMemory, deviceScope, info, "vkAllocateMemory");
        }
    }
    throw Error(ExitCode::NoDevice, fmt::format("{} has no memory of the needed type", deviceInfo.name));
}

std::vector<DeviceInfo> surveyDevices() {
    const VkApplicationInfo application = applicationInfo();
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    VkInstance instance = makeInstance(info);
    std::vector<DeviceInfo> devices = listDevices(instance);
    vkDestroyInstance(instance, nullptr);
    for (DeviceInfo& device : devices) {
        device.handle = VK_NULL_HANDLE;  // gone with the instance
    }
    return devices;
}

}  // namespace raytorus::gpu
