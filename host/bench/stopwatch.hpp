// SPDX-License-Identifier: MIT
// How long a device works on a submission.
#pragma once

#include <functional>
#include <string>

#include "gpu/timestamps.hpp"

namespace raytorus::bench {

/// On a GPU the device's timestamps, or, where it has none, the clock of the host. On a CPU the processor
/// time of this process, all threads together: what other programs take from the processor does not count.
class Stopwatch {
public:
    explicit Stopwatch(gpu::Context& context);

    /// Submits what `record` records, waits, and returns the seconds it took.
    double submit(const std::function<void(VkCommandBuffer)>& record) const;

    /// "processor time", "device timestamps" or "wall".
    static std::string clockOf(const gpu::DeviceInfo& info);

private:
    gpu::Context* context;
    bool onProcessor;
    gpu::Timestamps timestamps;
};

}  // namespace raytorus::bench
