// SPDX-License-Identifier: MIT
// One piece of work on the device that the host need not wait for.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>

#include "gpu/handle.hpp"

namespace raytorus::gpu {

class Context;

class Submission {
public:
    /// The context must outlive it.
    explicit Submission(Context& context);
    Submission(const Submission&) = delete;
    Submission& operator=(const Submission&) = delete;
    /// Waits for what runs, so that its objects can go.
    ~Submission();

    /// Records commands and lets them run; finish() comes before the next start(). They begin after `wait` is
    /// signalled, and signal `signal`; each may be left out. Submissions run in the order of their starts,
    /// but where no barrier orders them they may overlap.
    void start(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait = VK_NULL_HANDLE,
               VkSemaphore signal = VK_NULL_HANDLE);

    /// Waits until they are done, if any run. Throws Error{DeviceLost} if that takes longer than
    /// ContextOptions::timeoutSeconds.
    void finish();

private:
    Context* context;
    // Declared in this order so that the fence goes first, then the pool with its buffer.
    Handle<VkCommandPool, vkDestroyCommandPool> pool;
    Handle<VkFence, vkDestroyFence> fence;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    bool running = false;
};

}  // namespace raytorus::gpu
