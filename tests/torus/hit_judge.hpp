// SPDX-License-Identifier: MIT
// Holds the hits of trace.comp to the 113-bit reference, ray by ray, by the verifier's judge and bounds.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "judge/judge.hpp"
#include "reference/rays.hpp"

namespace raytorus::test {

/// What went wrong, or how far off what went right was.
struct HitTally {
    std::size_t judged = 0;   ///< rays whose verdict is clear
    std::size_t unclear = 0;  ///< rays too near a tangent, or with a hit too near one of their ends
    std::size_t hits = 0;     ///< judged rays that hit
    std::size_t faultCount = 0;
    std::vector<std::string> faults;  ///< the first ones, each with the ray that shows it
    double positionError = 0.0;       ///< the largest, in R + r
    double tError = 0.0;              ///< the largest, in ulp as judge::HitErrors has them
    double offSurface = 0.0;          ///< the largest distance of a position from the surface, in R + r
};

/// Asks all three queries of rays, and judges the answers.
class HitJudge {
public:
    /// Room for `capacity` rays at a time.
    explicit HitJudge(std::size_t capacity);

    /// `name` tells a failing ray's origin.
    HitTally judge(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                   const std::string& name);

    /// Verdicts and counts alone, of all rays whose ends are clear: near a tangent there is nothing else to
    /// ask, since the hits move without bound with the rounding of the ray.
    HitTally judgeVerdicts(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                           const std::string& name);

    /// Of each ray, however near to a tangent, what is wrong with its answers: see mismatch.
    std::vector<std::string> mismatches(const reference::Torus& torus,
                                        const std::vector<reference::Ray>& rays);

private:
    HitTally judgeAll(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                      const std::string& name, bool clearOnly);

    judge::Queries queries;
};

}  // namespace raytorus::test
