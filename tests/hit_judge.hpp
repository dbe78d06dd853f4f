// SPDX-License-Identifier: MIT
// Holds the hits of trace.comp to the reference, ray by ray.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "reference/rays.hpp"
#include "render/tracer.hpp"

namespace raytorus::test {

/// What went wrong, or how far off what went right was.
struct Judgement {
    std::size_t judged = 0;   ///< rays whose verdict is clear
    std::size_t unclear = 0;  ///< rays too near a tangent, or with a hit too near one of their ends
    std::size_t hits = 0;     ///< judged rays that hit
    std::size_t faultCount = 0;
    std::vector<std::string> faults;  ///< the first ones, each with the ray that shows it
    double positionError = 0.0;       ///< the largest, in R + r
    double tError = 0.0;              ///< the largest, in ulp as tBound has them
    double offSurface = 0.0;          ///< the largest distance of a position from the surface, in R + r
};

/// A verdict is clear if the distance to the tube along the line has no extremum nearer to the surface than
/// this part of r ...
inline constexpr double clearMargin = 1e-3;

/// ... and if neither end of the ray is nearer to it than this part of r, for a torus with R = 1. Less than
/// for extrema: there the sign of the distance decides, which float32 knows to some 2^-24 (R + r), thrice for
/// good measure.
inline double clearEndMargin(double minorRadius) {
    return std::max(2e-5, 2e-7 * (1.0 + minorRadius) / minorRadius);
}

/// How far a position may be from the exact hit of the ray as given, in R + r: half an ulp of each
/// coordinate, of which at most two reach up to R + r < 2 units (2^-24 sqrt 2 = 8.4e-8), and nothing else.
inline constexpr double positionBound = 9e-8;

/// How far t may be from the exact one, in ulp of t. Nearly always it is half an ulp; a flat crossing (a ray
/// nearly along a thin tube, or near the tip of a horn) can double it. Of a t shorter than (R + r) / 16, the
/// ulp of that, 2^-27 (R + r): the line is known to some 2^-40 (R + r), which a slanting surface makes a
/// hundred times longer.
inline constexpr double tBound = 1.0;

/// Asks all three questions of rays, and judges the answers.
class HitJudge {
public:
    /// Room for `capacity` rays at a time.
    explicit HitJudge(std::size_t capacity);

    /// `name` tells a failing ray's origin.
    Judgement judge(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                    const std::string& name);

    /// Verdicts and counts alone, of all rays whose ends are clear: near a tangent there is nothing else to
    /// ask, since the hits move without bound with the rounding of the ray.
    Judgement judgeVerdicts(const reference::Torus& torus, const std::vector<reference::Ray>& rays,
                            const std::string& name);

    /// Of each ray, however near to a tangent, what is wrong with its answers: see mismatch.
    std::vector<std::string> mismatches(const reference::Torus& torus,
                                        const std::vector<reference::Ray>& rays);

private:
    struct Answers;
    Answers ask(const reference::Torus& torus, const std::vector<reference::Ray>& rays);

    render::Tracer nearest;
    render::Tracer all;
    render::Tracer any;
};

}  // namespace raytorus::test
