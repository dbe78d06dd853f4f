// SPDX-License-Identifier: MIT
// Rays that leave the surface where the fast tier has found a hit, as shadows and reflections do. Seeds are
// printed; RAYTORUS_SEED replays.
#include <gtest/gtest.h>

#include <cmath>

#include "fast_rays.hpp"
#include "reference/promise.hpp"
#include "support/special_floats.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::test {
namespace {

// A ray from where a hit is, rounded, at 6 degrees to the surface or more, outwards or inwards, from t = 0
// on.
Trial leavingFrom(const FastAnswer& asked, reference::Random& random) {
    const auto& [x, y, z] = asked.all.position[0];
    const auto normal = reference::toDouble(reference::normal(asked.trial.torus, {x, y, z}));
    for (;;) {
        const reference::DoubleVec3 d = random.onSphere();
        if (std::abs(normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2]) >= 0.1) {
            return {asked.trial.torus,
                    {{x, y, z},
                     0,
                     {static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2])},
                     infinity}};
        }
    }
}

// Not at once, that is: of what is further than 1e-3 r, the number of hits is right. The place may be off the
// surface by the noise of the hit, which the march's blur covers.
TEST(FastTierLeaving, NoRayMeetsTheSurfaceThatItLeaves) {
    int judged = 0;
    forFastRays([&](const FastAnswer& asked) {
        if (asked.count() == 0 || asked.exact.clearance < reference::clearMargin) {
            return;
        }
        reference::Random random = freshNumbers(static_cast<std::uint64_t>(++judged));
        const Trial leaving = leavingFrom(asked, random);
        const auto [R, r] = leaving.torus;
        const ExactHits truth = exactHitsOf(leaving);
        const Long near = 1e-3L * Long{r};
        int expected = 0;
        for (int k = 0; k < truth.count; ++k) {
            expected += truth.hits[static_cast<std::size_t>(k)].t.high > near ? 1 : 0;
        }
        const FastAnswer again{leaving, truth, fastTier().all(R, r, trace::asTraceRay(leaving.ray))};
        if (truth.clearance >= reference::clearMargin && !again.nearTip()) {
            ASSERT_EQ(again.count(), expected) << leaving.text();
        }
    });
    EXPECT_GT(judged, 5000);
}

}  // namespace
}  // namespace raytorus::test
