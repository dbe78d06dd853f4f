// SPDX-License-Identifier: MIT
// The Vulkan instance, device and queue that everything else of gpu/ lives on. No window, ever.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/handle.hpp"
#include "gpu/submission.hpp"
#include "gpu/validation.hpp"

namespace raytorus::gpu {

struct ContextOptions {
    std::string device;                           ///< see pickDevice
    bool validate = false;                        ///< core and synchronization validation, into the log
    double timeoutSeconds = 120.0;                ///< for one submission; then the device counts as lost
    std::vector<const char*> instanceExtensions;  ///< for windows, which gpu/ itself knows nothing of
    std::vector<const char*> deviceExtensions;
    // Switched on where the device has it; then Context::hasFloat64 or hasPipelineStatistics says so.
    bool float64 = false;             ///< doubles in shaders
    bool pipelineStatistics = false;  ///< VK_KHR_pipeline_executable_properties
    /// Without what submitting needs: shaders can be compiled, and nothing can be run. For drivers that
    /// compile for a device that is not there.
    bool compileOnly = false;
};

class Context {
public:
    /// The log receives what the validation layers say until the Context is gone.
    Context(const ContextOptions& options, std::shared_ptr<ValidationLog> log);
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context();

    [[nodiscard]] const DeviceScope& scope() const { return deviceScope; }
    [[nodiscard]] VkInstance instance() const { return vkInstance; }
    [[nodiscard]] VkDevice device() const { return deviceScope.device; }
    [[nodiscard]] VkQueue queue() const { return vkQueue; }
    [[nodiscard]] const DeviceInfo& info() const { return deviceInfo; }
    [[nodiscard]] bool hasFloat64() const { return float64; }
    [[nodiscard]] bool hasPipelineStatistics() const { return pipelineStatistics; }

    /// Runs commands and waits until they are done; else as Submission::start.
    void submit(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait = VK_NULL_HANDLE,
                VkSemaphore signal = VK_NULL_HANDLE);

    /// Waits for a fence of a submission. Throws Error{DeviceLost} if that takes longer than
    /// ContextOptions::timeoutSeconds.
    void wait(VkFence fence);

    /// Memory for an object, of a type with the wanted properties (or, if there is none, the required ones).
    [[nodiscard]] Handle<VkDeviceMemory, vkFreeMemory> allocate(const VkMemoryRequirements& requirements,
                                                                VkMemoryPropertyFlags required,
                                                                VkMemoryPropertyFlags wanted) const;

private:
    void createInstance(const ContextOptions& options);
    void createDevice(const ContextOptions& options);
    void destroy() noexcept;

    std::shared_ptr<ValidationLog> log;
    double timeoutSeconds;
    VkInstance vkInstance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    DeviceInfo deviceInfo;
    DeviceScope deviceScope;
    VkQueue vkQueue = VK_NULL_HANDLE;
    bool float64 = false;
    bool pipelineStatistics = false;
    std::optional<Submission> submission;
};

/// Every device the loader offers, with the reasons against it; needs no suitable device. For `raytorus
/// doctor`.
std::vector<DeviceInfo> surveyDevices();

}  // namespace raytorus::gpu
