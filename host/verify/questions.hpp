// SPDX-License-Identifier: MIT
// All three questions of the same rays, through the real SPIR-V.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/torus_reference.hpp"
#include "render/tracer.hpp"

namespace raytorus::verify {

/// What torusIntersect, torusIntersectAll and torusOccluded said of one ray.
struct Answers {
    render::NearestHit nearest;
    render::AllHits all;
    float any;
};

/// A tracer a question, kept: each makes a pipeline, which takes some drivers a third of a second.
class Questions {
public:
    /// Room for `capacity` rays at a time. `shaders` may put another method in the place of trace.comp.
    Questions(gpu::Context& context, std::size_t capacity, const render::ShaderSource& shaders = {});

    /// The answers to up to `capacity` rays, in their order.
    std::vector<Answers> ask(const reference::Torus& torus, const std::vector<reference::Ray>& rays);

private:
    render::Tracer nearest;
    render::Tracer all;
    render::Tracer any;
};

}  // namespace raytorus::verify
