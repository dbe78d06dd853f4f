// SPDX-License-Identifier: MIT
// Physical devices: what each one is, whether it can run raytorus, and if not, why.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace raytorus::gpu {

struct DeviceInfo {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    std::uint32_t index = 0;  ///< in the order of the loader
    std::string name;
    std::string driverName;
    std::string driverInfo;  ///< the driver's version, as the driver says it
    std::string type;        ///< "discrete GPU", "CPU", ...
    std::uint32_t apiVersion = 0;
    std::uint32_t queueFamily = 0;   ///< with graphics and compute
    double timestampPeriod = 0.0;    ///< nanoseconds a tick; 0: the queue has no timestamps
    std::uint64_t deviceMemory = 0;  ///< bytes of the largest device-local heap
    VkPhysicalDeviceLimits limits{};
    std::vector<std::string> features;  ///< what it has of what raytorus can make use of
    std::vector<std::string> refusals;  ///< why it cannot be used, a sentence each; empty: it can

    [[nodiscard]] bool suitable() const { return refusals.empty(); }
};

/// "1.3.230".
std::string versionText(std::uint32_t version);

/// Every physical device of the instance, suitable or not. One that lacks an extension of `needed` is not.
std::vector<DeviceInfo> listDevices(VkInstance instance, std::span<const char* const> needed = {});

/// Picks a device. `selector` is empty (the best: discrete before integrated before virtual before CPU, then
/// the loader's order), an index, or part of a name or of the driver's name or version, whatever the case.
/// Throws Error{NoDevice} that says for each device why it was refused.
DeviceInfo pickDevice(const std::vector<DeviceInfo>& devices, const std::string& selector);

}  // namespace raytorus::gpu
