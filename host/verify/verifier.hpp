// SPDX-License-Identifier: MIT
// Runs groups of rays through the real SPIR-V and judges every answer, on all processors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "judge/queries.hpp"
#include "verify/ray_group.hpp"
#include "verify/statistics.hpp"

namespace raytorus::verify {

class Verifier {
public:
    /// `shaders` may put another method in the place of trace.comp. `threads` of 0: as many as there are
    /// processors.
    explicit Verifier(gpu::Context& context, const trace::ShaderSource& shaders = {}, unsigned threads = 0);

    /// The rays 0 ... count - 1 of a ray group. `progress`, if given, hears how many are done.
    Statistics verify(const RayGroup& group, std::uint64_t seed, std::uint64_t count,
                      const std::function<void(std::uint64_t)>& progress = {});

    /// One ray, by the arbiter, however near a tangent.
    struct Replay {
        reference::Intersections exact;
        judge::Answers answers;
        judge::Judgement judgement;
    };
    Replay replay(const reference::Torus& torus, const reference::Ray& ray);

private:
    Statistics judgeBlock(const RayGroup& group, const std::vector<reference::Ray>& rays,
                          const std::vector<judge::Answers>& answers) const;

    unsigned threads;
    judge::Queries queries;
};

}  // namespace raytorus::verify
