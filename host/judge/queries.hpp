// SPDX-License-Identifier: MIT
// All three queries of the same rays, through the real SPIR-V.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/torus_reference.hpp"
#include "trace/tracer.hpp"

namespace raytorus::judge {

/// What torusIntersect, torusIntersectAll and torusOccluded said of one ray.
struct Answers {
    trace::NearestHit nearest;
    trace::AllHits all;
    float any;
};

/// A tracer a query, kept: each makes a pipeline, which takes some drivers a third of a second.
class Queries {
public:
    /// Room for `capacity` rays at a time. `shaders` may put another method in the place of trace.comp.
    Queries(gpu::Context& context, std::size_t capacity, const trace::ShaderSource& shaders = {});

    /// The answers to up to `capacity` rays, in their order.
    std::vector<Answers> answer(const reference::Torus& torus, const std::vector<reference::Ray>& rays);

private:
    trace::Tracer nearest;
    trace::Tracer all;
    trace::Tracer any;
};

}  // namespace raytorus::judge
