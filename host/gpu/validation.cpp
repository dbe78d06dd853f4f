// SPDX-License-Identifier: MIT
#include "gpu/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.hpp"
#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                       VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    const char* level = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT ? "error" : "warning";
    const char* id = data->pMessageIdName == nullptr ? "" : data->pMessageIdName;
    static_cast<ValidationLog*>(user)->add(fmt::format("{} {}: {}", level, id, data->pMessage));
    return VK_FALSE;
}

}  // namespace

void ValidationLog::add(std::string message) {
    const std::lock_guard lock(mutex);
    if (listener) {
        listener(message);
    }
    log.push_back(std::move(message));
}

std::vector<std::string> ValidationLog::messages() const {
    const std::lock_guard lock(mutex);
    return log;
}

void ValidationLog::requireEmpty() const {
    constexpr std::size_t shown = 5;
    const std::vector<std::string> all = messages();
    if (all.empty()) {
        return;
    }
    std::string text = fmt::format("the Vulkan validation layers reported {} message(s)", all.size());
    for (std::size_t i = 0; i < std::min(all.size(), listener ? 0 : shown); ++i) {
        text += "\n  " + all[i];
    }
    throw Error(ExitCode::ValidationMessage, text);
}

std::vector<VkLayerProperties> instanceLayers() {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "vkEnumerateInstanceLayerProperties");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "vkEnumerateInstanceLayerProperties");
    return layers;
}

bool validationLayerAvailable() {
    const std::vector<VkLayerProperties> layers = instanceLayers();
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::string_view(layer.layerName) == "VK_LAYER_KHRONOS_validation";
    });
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // "General" messages are the loader's, about files and drivers; they are not about our use of Vulkan.
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = receive;
    info.pUserData = &log;
    return info;
}

}  // namespace raytorus::gpu
