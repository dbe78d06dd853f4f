// SPDX-License-Identifier: MIT
// How often a method is wrong on the rays that it is timed on: a fast wrong answer is no answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/kernel.hpp"
#include "bench/view.hpp"
#include "judge/judge.hpp"
#include "trace/tracer.hpp"

namespace raytorus::bench {

struct Correctness {
    std::size_t judged = 0;    ///< rays that are clear: see judge::isClear
    std::size_t wrong = 0;     ///< of these: hit or miss wrong, or for all hits their number or their order
    std::size_t gross = 0;     ///< of the rest: a position off by more than 0.01 r
    double positionP99 = 0.0;  ///< of the rest: 99 of 100 positions are off by less, in R + r

    [[nodiscard]] bool right() const { return wrong == 0 && gross == 0; }
};

/// The exact hits of a workload's rays. Made once; every method is held to it.
class ReferenceHits {
public:
    /// `threads` of 0: as many as there are processors.
    ReferenceHits(const reference::Torus& torus, std::vector<trace::TraceRay> rays, unsigned threads = 0);

    /// The part of the rays that hit, 0 to 1.
    [[nodiscard]] double hitPart() const;

    /// `answers`: as Kernel::answers has them. Whoever differs from hits in doubles makes that ray's hits
    /// be found again in 104 bits, and counts as wrong only if it differs from that too.
    Correctness judge(trace::Query query, std::span<const float> answers);

private:
    struct Entry {
        judge::ExactHits exact;
        bool clear = false;
        bool precise = false;
    };

    reference::Torus torus;
    std::vector<trace::TraceRay> rays;
    unsigned threads;
    std::vector<Entry> entries;
};

/// The part of these rays that hit, as views are aimed by: every `stride`th is looked at.
double hitPartOf(const reference::Torus& torus, std::span<const trace::TraceRay> rays, std::size_t stride);

/// Where the workload's rays are seen from, so that the part of them that it wants hits.
RayView aimedView(Kernel& kernel, const Workload& workload, std::uint64_t seed);

}  // namespace raytorus::bench
