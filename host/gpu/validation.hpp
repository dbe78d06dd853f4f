// SPDX-License-Identifier: MIT
// What the validation layers say, collected so that none of it is lost: also what they say while the instance
// is being created and destroyed, which is why the log outlives the Context that writes to it.
#pragma once

#include <vulkan/vulkan.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace raytorus::gpu {

class ValidationLog {
public:
    void add(std::string message);
    [[nodiscard]] std::vector<std::string> messages() const;

    /// Throws Error{ValidationMessage} if there is any message; its text holds the first ones.
    void requireEmpty() const;

private:
    mutable std::mutex mutex;
    std::vector<std::string> log;
};

/// Every layer that the loader knows.
std::vector<VkLayerProperties> instanceLayers();

/// Whether the Khronos validation layer is installed.
bool validationLayerAvailable();

/// Warnings and errors of the layers, and nothing else, go to the log. Chain it to the instance and create a
/// messenger from it. The log must outlive both.
VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log);

}  // namespace raytorus::gpu
