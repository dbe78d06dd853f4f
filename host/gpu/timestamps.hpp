// SPDX-License-Identifier: MIT
// How long the device itself took, by a pair of timestamps.
#pragma once

#include <vulkan/vulkan.h>

#include <optional>

#include "gpu/context.hpp"

namespace raytorus::gpu {

class Timestamps {
public:
    explicit Timestamps(const Context& context);

    /// Record both into the same command buffer, around the work.
    void begin(VkCommandBuffer commands) const;
    void end(VkCommandBuffer commands) const;

    /// Seconds between the two, once the submission is done. Nothing where the queue has no timestamps.
    [[nodiscard]] std::optional<double> seconds() const;

private:
    VkDevice device;
    double period;  ///< nanoseconds a tick; kept as floating point: it is a fraction on many devices
    Handle<VkQueryPool, vkDestroyQueryPool> pool;
};

}  // namespace raytorus::gpu
