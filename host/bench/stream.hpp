// SPDX-License-Identifier: MIT
// trace.comp on a device, timed: one ray an invocation, read from a buffer, its answer written to another.
// What memory costs beside the arithmetic.
#pragma once

#include "bench/kernel.hpp"

namespace raytorus::bench {

class Stream {
public:
    /// The rays again and again, `copies` times.
    Stream(gpu::Context& context, const reference::Torus& torus, std::span<const trace::TraceRay> rays,
           std::size_t copies);

    [[nodiscard]] std::size_t rayCount() const { return count; }

    /// Answers all rays once.
    Shot time(const TimedMethod& method, trace::Query query);

    /// What the last run has answered to the rays of one copy, as Kernel::answers has it.
    [[nodiscard]] std::vector<float> answers(trace::Query query) const;

private:
    gpu::Context* context;
    reference::Torus torus;
    std::size_t countOfOne;
    std::size_t count;
    Stopwatch stopwatch;
    gpu::Buffer rayBuffer;
    gpu::Buffer hitBuffer;
    std::map<std::pair<std::string, std::uint32_t>, gpu::Pipeline> pipelines;
};

}  // namespace raytorus::bench
