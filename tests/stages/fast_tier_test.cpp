// SPDX-License-Identifier: MIT
// The fast tier as C++: its three functions agree, and on clear rays its hits are right to float32's noise.
// Seeds are printed; RAYTORUS_SEED replays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fast_rays.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::test {
namespace {

using trace::TraceRay;

// Of clear rays only: at an end within rounding of a hit torusOccluded, which refines nothing, may say
// otherwise. On any ray the two others are the same search.
TEST(FastTier, TheThreeFunctionsAgree) {
    int hits = 0;
    forFastRays([&](const FastAnswer& asked) {
        const auto [R, r] = asked.trial.torus;
        const TraceRay ray = trace::asTraceRay(asked.trial.ray);
        const trace::NearestHit nearest = fastTier().nearest(R, r, ray);
        ASSERT_EQ(nearest.hit > 0, asked.count() > 0) << asked.trial.text();
        if (nearest.hit > 0) {
            ++hits;
            ASSERT_EQ(nearest.t, asked.all.t[0]) << asked.trial.text();
            ASSERT_TRUE(std::equal(nearest.position, nearest.position + 3, asked.all.position[0]))
                << asked.trial.text();
        }
        if (asked.hasClearEnds()) {
            ASSERT_EQ(fastTier().any(R, r, ray), nearest.hit > 0) << asked.trial.text();
        }
    });
    EXPECT_GT(hits, 5000);
}

// The end of a ray decides, not the padding of the line's end, which is longer than this: half of it before a
// hit, the hit is gone. That is more than the noise of a steep crossing but for one in some thousand.
TEST(FastTier, AHitJustBeyondTheRaysEndIsNone) {
    int hits = 0;
    int nearest = 0;
    int all = 0;
    int any = 0;
    forFastRays([&](const FastAnswer& asked) {
        const auto [R, r] = asked.trial.torus;
        if (asked.exact.count == 0 || asked.exact.clearance < 0.1 || r > 1 || asked.nearTip()) {
            return;
        }
        const reference::QuadVec3 d = reference::toQuad(asked.trial.ray.direction);
        const double length = std::sqrt(reference::toDouble(reference::dot(d, d)));
        const double t = asked.exact.hits[0].t.high;
        TraceRay ray = trace::asTraceRay(asked.trial.ray);
        ray.tMax = static_cast<float>(t - 5e-6 / length);
        // From afar t has an ulp as long as that.
        const double before = (t - double{ray.tMax}) * length;
        if (ray.tMax >= ray.tMin && before > 3e-6 && before < 7e-6) {
            ++hits;
            nearest += fastTier().nearest(R, r, ray).hit > 0 ? 1 : 0;
            all += fastTier().all(R, r, ray).count > 0 ? 1 : 0;
            any += fastTier().any(R, r, ray) ? 1 : 0;
        }
    });
    EXPECT_GT(hits, 1000);
    EXPECT_LE(nearest, hits / 100);
    EXPECT_LE(all, hits / 100);
    EXPECT_LE(any, hits / 100);
}

// A ray that starts and ends on the same side has an even number of hits, also where it touches: both there
// or neither. Not beside a tip.
TEST(FastTier, HitsAreInPairsInOrderAndWithinTheRay) {
    int touching = 0;
    forFastRays([&](const FastAnswer& asked) {
        const reference::Ray& ray = asked.trial.ray;
        for (int k = 0; k < asked.count(); ++k) {
            ASSERT_LE(k == 0 ? ray.tMin : asked.all.t[k - 1], asked.all.t[k]) << asked.trial.text();
            ASSERT_LE(asked.all.t[k], ray.tMax) << asked.trial.text();
        }
        if (asked.hasClearEnds() && !asked.nearTip()) {
            touching += asked.exact.clearance < 1e-4 ? 1 : 0;
            ASSERT_EQ(asked.count() % 2, asked.exact.count % 2) << asked.trial.text();
        }
    });
    EXPECT_GT(touching, 500);
}

// Clear as for the exact tier. A position is off by the line's rounding, some 2^-23 (R + r), over the slope
// of the crossing: 99 % by less than 1e-6 (R + r), and a ray at a grazing angle by more.
TEST(FastTier, ClearRaysAreRight) {
    int judged = 0;
    std::vector<double> errors;
    forFastRays([&](const FastAnswer& asked) {
        const auto [R, r] = asked.trial.torus;
        if (!asked.isClear() || asked.nearTip()) {
            return;
        }
        ++judged;
        ASSERT_EQ(asked.count(), asked.exact.count) << asked.trial.text();
        for (int k = 0; k < asked.count(); ++k) {
            double off2 = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double exact = asked.exact.hits[static_cast<std::size_t>(k)]
                                         .position[static_cast<std::size_t>(axis)]
                                         .high;
                const double off = exact - double{asked.all.position[k][axis]};
                off2 += off * off;
            }
            errors.push_back(std::sqrt(off2) / (double{R} + double{r}));
            ASSERT_LE(errors.back(), 5e-3) << asked.trial.text();
        }
    });
    EXPECT_GT(judged, 15000);
    ASSERT_GT(errors.size(), 10000U);
    std::ranges::sort(errors);
    EXPECT_LE(errors[errors.size() * 99 / 100], 1e-6);
}

}  // namespace
}  // namespace raytorus::test
