// SPDX-License-Identifier: MIT
// One ray's answers, held to the exact.
#pragma once

#include <algorithm>
#include <array>

#include "judge/queries.hpp"
#include "reference/promise.hpp"
#include "reference/torus_reference.hpp"

namespace raytorus::judge {

/// What the reference says, rounded to doubles: 1e-16 of a position is a billionth of what floats can be off.
using ExactHits = reference::BasicIntersections<double>;

/// By the 113-bit reference. The arbiter: some ten thousand rays a second.
ExactHits arbiterHits(const reference::Torus& torus, const reference::Ray& ray);

/// In 104 bits throughout, some hundred thousand rays a second: for rays near tangents.
ExactHits preciseHits(const reference::Torus& torus, const reference::Ray& ray);

/// Reduced in 104 bits, solved in doubles, some half million rays a second: on clear rays positions are
/// right to 1e-10 (R + r), at any distance.
ExactHits quickHits(const reference::Torus& torus, const reference::Ray& ray);

enum class Fault {
    None,
    NonFinite,     ///< NaN or infinity in a hit
    Missed,        ///< a hit, and the nearest-hit function says that there is none
    FalseHit,      ///< no hit, and it says that there is one
    WrongCount,    ///< all-hits function: another number of hits
    Order,         ///< hits not in ascending t
    Disagreement,  ///< any-hit differs from nearest, or the nearest's bits from those of the first of all
    Gross,         ///< a position off by grossError or more
};
inline constexpr std::size_t faultKinds = 8;

/// Whether the three answers say the same: a hit or none, and the nearest hit has the bits of the first of
/// all.
bool agree(const Answers& answers);

/// "missed", as tables head their columns.
const char* nameOf(Fault fault);

using reference::clearEndMargin;
using reference::clearMargin;
using reference::grossError;
using reference::positionBound;

/// Whether a ray has one right answer, by these margins. Both are measured on the ray as rounded to floats.
inline bool isClear(const ExactHits& exact, double tangentMargin, double endMargin) {
    return exact.clearance >= tangentMargin && exact.endClearance() >= endMargin;
}

/// How far its t may be off, in ulp as HitErrors has them: half an ulp where it is rounded once, which it
/// nearly always is. A flat crossing (a ray nearly along a thin tube, or near the tip of a horn) adds to it.
inline constexpr double tBound = 2.0;

/// How far off a hit is.
struct HitErrors {
    double position;  ///< from the exact hit of the ray as given, in R + r
    /// In ulp of t; of (R + r) / 16, which is 2^-27 (R + r) or more, if t is shorter than that: the line is
    /// known to some 2^-40 (R + r), which a slanting surface makes a hundred times longer.
    double t;
    double surface;  ///< of the position from the surface, in R + r
};

/// The ulp that HitErrors measures t in. `size` is R + r in lengths of the direction.
double ulpOf(float t, double size);

struct Judgement {
    Fault fault = Fault::None;
    int hitCount = 0;  ///< entries of `errors`; 0 if the counts differ
    std::array<HitErrors, 4> errors{};
};

Judgement judge(const reference::Torus& torus, const reference::Ray& ray, const ExactHits& exact,
                const Answers& answers);

}  // namespace raytorus::judge
