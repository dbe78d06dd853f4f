// SPDX-License-Identifier: MIT
// bench.comp on a device: rays made there, answered by a method, timed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "bench/stopwatch.hpp"
#include "bench/timed_method.hpp"
#include "bench/view.hpp"
#include "gpu/pipeline.hpp"

namespace raytorus::bench {

/// One timed run of a method over all rays.
struct Shot {
    double seconds = 0.0;        ///< of the whole run
    double rays = 1.0;           ///< that it answered, each as often as there are layers
    std::uint32_t checksum = 0;  ///< see checksumOf; of the first layer
    bool layersAgree = true;     ///< whether every layer has added up the same
};

/// The sum of the bits of all numbers of all answers, modulo 2^32.
std::uint32_t checksumOf(std::span<const float> answers);

class Kernel {
public:
    /// `side`: of the picture, in blocks of 64 x 64 rays.
    Kernel(gpu::Context& context, std::uint32_t side);

    [[nodiscard]] std::uint32_t pixels() const;
    [[nodiscard]] std::size_t rayCount() const;

    /// The rays of a view, as bench.comp makes them, in the order in which it answers them.
    std::vector<trace::TraceRay> rays(Pattern pattern, const RayView& view);

    /// The answers to them: answerFloats(query) a ray.
    std::vector<float> answers(const TimedMethod& method, trace::Query query, Pattern pattern,
                               const RayView& view);

    /// Answers all rays of the view `layers` times in one submission.
    Shot time(const TimedMethod& method, trace::Query query, Pattern pattern, const RayView& view,
              std::uint32_t layers);

    /// Lets go of all pipelines. Where a driver for processors puts their code can cost a third of the time,
    /// for as long as they live.
    void forgetPipelines() { pipelines.clear(); }

private:
    using Key = std::tuple<std::string, std::uint32_t, Pattern, std::uint32_t>;

    gpu::Pipeline& pipeline(const TimedMethod& method, trace::Query query, Pattern pattern,
                            std::uint32_t task);
    void reserve(std::size_t words);
    double run(gpu::Pipeline& chosen, const RayView& view, std::uint32_t layers);

    gpu::Context* context;
    std::uint32_t side;
    Stopwatch stopwatch;
    gpu::Buffer output;
    std::map<Key, gpu::Pipeline> pipelines;  ///< kept: each takes some drivers a third of a second to make
};

/// Floats of an answer that Kernel gives: hit, t and position; count, four t and four positions; or hit.
std::size_t answerFloats(trace::Query query);

/// What trace.comp calls a query.
std::uint32_t queryConstant(trace::Query query);

}  // namespace raytorus::bench
