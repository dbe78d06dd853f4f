// SPDX-License-Identifier: MIT
// Rays in, hits out, through trace.comp: the same SPIR-V that pictures are made of, without a picture.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/submission.hpp"
#include "reference/torus_reference.hpp"
#include "trace/hits.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::trace {

/// A torus, one kind of query, and room for a number of rays at a time, or for a few such numbers: while
/// the device answers one batch, the host can fill another and read a third.
class Tracer {
public:
    /// Throws Error{OutOfMemory} if the device allows no buffer for so many rays; see maxCapacity.
    Tracer(gpu::Context& context, Query query, std::size_t capacity, const ShaderSource& shaders = {},
           std::size_t batches = 1);

    /// The most rays that the device takes at a time.
    static std::size_t maxCapacity(const gpu::Context& context, Query query);

    /// Traces up to `capacity` rays. The answer is valid until the next call: hitFloats(query) floats a ray.
    std::span<const float> trace(const reference::Torus& torus, std::span<const TraceRay> rays);

    /// Room for `capacity` rays, to be filled while the device is not at this batch. The memory may be
    /// uncached: write it in order and do not read it.
    [[nodiscard]] std::span<TraceRay> rays(std::size_t batch) const;

    /// Lets the device answer the first `count` rays of a batch, which must be finished, and does not wait.
    void start(std::size_t batch, const reference::Torus& torus, std::size_t count);

    /// Waits for a batch. The answer is valid until its next start.
    std::span<const float> finish(std::size_t batch);

private:
    struct Batch {
        Batch(gpu::Context& context, std::size_t capacity, std::size_t hitFloats);
        gpu::Buffer rays;
        gpu::Buffer hits;
        std::size_t count = 0;
        gpu::Submission submission;  // last: it ends before the buffers go
    };

    Query query;
    std::size_t capacity;
    gpu::Pipeline pipeline;
    std::vector<std::unique_ptr<Batch>> batches;  // after the pipeline, so that they end before it goes
};

}  // namespace raytorus::trace
