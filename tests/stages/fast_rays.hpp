// SPDX-License-Identifier: MIT
// Fresh rays for the tests of the fast tier, with what it and the reference say of them.
#pragma once

#include <functional>

#include "reference/double_double.hpp"
#include "reference/intersect.hpp"
#include "stage_rays.hpp"

namespace raytorus::test {

using ExactHits = reference::BasicIntersections<reference::DoubleDouble>;

ExactHits exactHitsOf(const Trial& trial);

struct FastAnswer {
    Trial trial;
    ExactHits exact;
    trace::AllHits all;

    [[nodiscard]] int count() const { return static_cast<int>(all.count); }
    /// Whether the exact tier is right on it for sure: no end and no extremum is near the surface.
    [[nodiscard]] bool hasClearEnds() const;
    [[nodiscard]] bool isClear() const;
    /// See ExactLine::meetsATip.
    [[nodiscard]] bool nearTip() const;
};

/// Rays of every class at tori of which float32 sees the tube, from up to 10^4 R. Ends at the first fatal
/// failure.
void forFastRays(const std::function<void(const FastAnswer&)>& check);

}  // namespace raytorus::test
