// SPDX-License-Identifier: MIT
// What the validation layers say, collected so that none of it is lost: also what they say while the instance
// is being created and destroyed, which is why the log outlives the Context that writes to it.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace raytorus::gpu {

class ValidationLog {
public:
    ValidationLog() = default;
    /// `listener` hears each message as it comes: what is said before a driver crashes would else be lost
    /// with the log.
    explicit ValidationLog(std::function<void(const std::string&)> messageListener)
        : listener(std::move(messageListener)) {}

    void add(std::string message);
    [[nodiscard]] std::vector<std::string> messages() const;

    /// Throws Error{ValidationMessage} if there is any message; its text holds the first ones, if nobody
    /// listened.
    void requireEmpty() const;

private:
    mutable std::mutex mutex;
    std::vector<std::string> log;
    std::function<void(const std::string&)> listener;
};

/// Every layer that the loader knows.
std::vector<VkLayerProperties> instanceLayers();

/// Whether the Khronos validation layer is installed.
bool validationLayerAvailable();

/// Warnings and errors of the layers, and nothing else, go to the log. Chain it to the instance and create a
/// messenger from it. The log must outlive both.
VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log);

}  // namespace raytorus::gpu
