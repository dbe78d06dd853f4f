// SPDX-License-Identifier: MIT
#include "gpu/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

constexpr std::uint32_t requiredApi = VK_API_VERSION_1_3;
constexpr VkQueueFlags requiredQueue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;

std::string typeName(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

int preference(const DeviceInfo& device) {
    const char* const order[] = {"discrete GPU", "integrated GPU", "virtual GPU", "CPU"};
    const auto* found = std::find(std::begin(order), std::end(order), device.type);
    return static_cast<int>(found - std::begin(order));
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

void findQueue(DeviceInfo& device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device.handle, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device.handle, &count, families.data());
    const auto found = std::find_if(families.begin(), families.end(), [](const auto& family) {
        return (family.queueFlags & requiredQueue) == requiredQueue;
    });
    if (found == families.end()) {
        device.refusals.emplace_back("no queue family does both graphics and compute");
        return;
    }
    device.queueFamily = static_cast<std::uint32_t>(found - families.begin());
    device.timestampPeriod =
        found->timestampValidBits > 0 ? static_cast<double>(device.limits.timestampPeriod) : 0.0;
}

void checkFeatures(DeviceInfo& device) {
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13, {}};
    vkGetPhysicalDeviceFeatures2(device.handle, &features);
    const auto require = [&device](VkBool32 present, const char* name) {
        (present == VK_TRUE ? device.features : device.refusals)
            .push_back(present == VK_TRUE ? name : fmt::format("the feature {} is missing", name));
    };
    require(features13.dynamicRendering, "dynamicRendering");
    require(features13.synchronization2, "synchronization2");
    require(features13.maintenance4, "maintenance4");
    if (features.features.shaderFloat64 == VK_TRUE) {
        device.features.emplace_back("shaderFloat64 (not needed)");
    }
    VkFormatProperties format{};
    vkGetPhysicalDeviceFormatProperties(device.handle, VK_FORMAT_R32G32B32A32_SFLOAT, &format);
    constexpr VkFormatFeatureFlags needed = VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT |
                                            VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT |
                                            VK_FORMAT_FEATURE_TRANSFER_SRC_BIT;
    if ((format.optimalTilingFeatures & needed) != needed) {
        device.refusals.emplace_back("R32G32B32A32_SFLOAT cannot be a colour attachment and a storage image");
    }
}

DeviceInfo describe(VkPhysicalDevice handle, std::uint32_t index) {
    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vkGetPhysicalDeviceProperties2(handle, &properties);
    const VkPhysicalDeviceProperties& core = properties.properties;
    DeviceInfo device;
    device.handle = handle;
    device.index = index;
    device.name = core.deviceName;
    device.driverName = driver.driverName;
    device.driverInfo = driver.driverInfo;
    device.type = typeName(core.deviceType);
    device.apiVersion = core.apiVersion;
    device.limits = core.limits;
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(handle, &memory);
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0) {
            device.deviceMemory = std::max<std::uint64_t>(device.deviceMemory, memory.memoryHeaps[i].size);
        }
    }
    if (core.apiVersion < requiredApi) {
        device.refusals.push_back(fmt::format("it has Vulkan {}, and {} is needed",
                                              versionText(core.apiVersion), versionText(requiredApi)));
        return device;  // asking an older device for newer features is not allowed
    }
    findQueue(device);
    checkFeatures(device);
    return device;
}

void checkExtensions(DeviceInfo& device, std::span<const char* const> needed) {
    if (needed.empty()) {
        return;
    }
    std::uint32_t count = 0;
    check(vkEnumerateDeviceExtensionProperties(device.handle, nullptr, &count, nullptr),
          "vkEnumerateDeviceExtensionProperties");
    std::vector<VkExtensionProperties> offered(count);
    check(vkEnumerateDeviceExtensionProperties(device.handle, nullptr, &count, offered.data()),
          "vkEnumerateDeviceExtensionProperties");
    for (const std::string_view name : needed) {
        const bool found =
            std::any_of(offered.begin(), offered.end(),
                        [name](const VkExtensionProperties& e) { return name == e.extensionName; });
        if (!found) {
            device.refusals.push_back(fmt::format("it lacks {}", name));
        }
    }
}

std::string refusalText(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (const DeviceInfo& device : devices) {
        text += fmt::format("\n  {}: {} ({})", device.index, device.name, device.driverInfo);
        for (const std::string& refusal : device.refusals) {
            text += "\n     refused: " + refusal;
        }
    }
    return text;
}

std::optional<std::size_t> asIndex(const std::string& text) {
    if (text.empty() || text.size() > 6 || !std::all_of(text.begin(), text.end(), ::isdigit)) {
        return std::nullopt;
    }
    return std::stoul(text);
}

}  // namespace

std::string versionText(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

std::vector<DeviceInfo> listDevices(VkInstance instance, std::span<const char* const> needed) {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> handles(count);
    check(vkEnumeratePhysicalDevices(instance, &count, handles.data()), "vkEnumeratePhysicalDevices");
    std::vector<DeviceInfo> devices;
    devices.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        devices.push_back(describe(handles[i], i));
        checkExtensions(devices.back(), needed);
    }
    return devices;
}

DeviceInfo pickDevice(const std::vector<DeviceInfo>& devices, const std::string& selector) {
    if (devices.empty()) {
        throw Error(
            ExitCode::NoDevice,
            "no Vulkan device: install a driver (Debian: mesa-vulkan-drivers has one that needs no GPU)");
    }
    const auto index = asIndex(selector);
    const std::string wanted = lowerCase(selector);
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& device : devices) {
        const std::string description =
            lowerCase(device.name + " " + device.driverName + " " + device.driverInfo);
        const bool named = index ? *index == device.index : description.find(wanted) != std::string::npos;
        if (named && device.suitable() && (best == nullptr || preference(device) < preference(*best))) {
            best = &device;
        }
    }
    if (best == nullptr) {
        throw Error(ExitCode::NoDevice,
                    fmt::format("no suitable Vulkan device{}; there are:{}",
                                selector.empty() ? "" : " matches '" + selector + "'", refusalText(devices)));
    }
    return *best;
}

}  // namespace raytorus::gpu
