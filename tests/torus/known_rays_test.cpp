// SPDX-License-Identifier: MIT
// Rays whose hits are known by hand, and rays that have broken others.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "judge/queries.hpp"
#include "reference/torus_reference.hpp"
#include "support/device_fixture.hpp"
#include "support/special_floats.hpp"
#include "trace/tracer.hpp"

namespace raytorus {
namespace {

using trace::AllHits;
using trace::TraceRay;

AllHits traceOne(const reference::Torus& torus, const TraceRay& ray) {
    trace::Tracer tracer(test::device(), trace::Query::All, 1);
    const std::span<const float> values = tracer.trace(torus, {&ray, 1});
    AllHits hits{};
    std::memcpy(&hits, values.data(), sizeof(hits));
    return hits;
}

struct Known {
    const char* name;
    float majorRadius;
    float minorRadius;
    TraceRay ray;
    std::vector<double> t;
    double tolerance;  ///< of t
};

void PrintTo(const Known& known, std::ostream* out) {
    *out << known.name;
}

// Half an ulp of numbers up to 4, twice: the shift and the root.
constexpr double ulps = 5e-7;

class KnownRays : public test::DeviceTest, public testing::WithParamInterface<Known> {};

TEST_P(KnownRays, HitWhereTheyMust) {
    const Known& known = GetParam();
    const AllHits hits = traceOne({known.majorRadius, known.minorRadius}, known.ray);
    ASSERT_EQ(hits.count, static_cast<float>(known.t.size()));
    for (std::size_t i = 0; i < known.t.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(hits.t[i]), known.t[i], known.tolerance) << i;
    }
}

// The nearer a hit, the more digits t has: a solver that knows places along the ray to 2^-33 of the torus
// alone would have lost half of them here.
using NearHits = test::DeviceTest;

TEST_F(NearHits, HaveAllDigitsOfTheirT) {
    constexpr float minorRadius = 0.25F;
    std::vector<reference::Ray> rays;
    for (const float away : {0.05F, 0.01F, 0.001F}) {
        for (int i = 1; i < 64; ++i) {
            // Towards the outer equator, at angles of up to 63 degrees.
            const float aside = 0.03F * static_cast<float>(i);
            rays.push_back({{1 + minorRadius + away, aside * away, 0.3F * away},
                            0,
                            {-0.9F, 0.013F * static_cast<float>(i), 0.1F},
                            infinity});
        }
    }
    const reference::Torus torus{1, minorRadius};
    const std::vector<judge::Answers> answers =
        judge::Queries(test::device(), rays.size()).answer(torus, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const reference::Intersections truth = reference::intersect(torus, rays[i]);
        ASSERT_GE(truth.count, 1) << i;
        const trace::NearestHit& hit = answers[i].nearest;
        const double t = reference::toDouble(truth.hits[0].t);
        const double ulp = std::exp2(std::floor(std::log2(t)) - 23);
        EXPECT_EQ(hit.hit, 1.0F) << i;
        EXPECT_NEAR(static_cast<double>(hit.t), t, 0.75 * ulp) << i;
    }
}

const double s2 = std::sqrt(2.0);

INSTANTIATE_TEST_SUITE_P(
    All, KnownRays,
    testing::Values(
        Known{"alongX", 1, 0.25F, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, {1.75, 2.25, 3.75, 4.25}, ulps},
        Known{"alongMinusX", 1, 0.25F, {{-3, 0, 0}, 0, {1, 0, 0}, infinity}, {1.75, 2.25, 3.75, 4.25}, ulps},
        Known{"longDirection",
              1,
              0.25F,
              {{3, 0, 0}, 0, {-4, 0, 0}, infinity},
              {0.4375, 0.5625, 0.9375, 1.0625},
              ulps},
        Known{"parallelToTheAxis", 1, 0.25F, {{1, 0, 3}, 0, {0, 0, -1}, infinity}, {2.75, 3.25}, ulps},
        Known{"alongTheAxisThroughTheHole", 1, 0.25F, {{0, 0, 3}, 0, {0, 0, -1}, infinity}, {}, ulps},
        Known{"alongTheAxisOfASpindle", 1, 1.25F, {{0, 0, 3}, 0, {0, 0, -1}, infinity}, {2.25, 3.75}, ulps},
        Known{"throughTheMiddleOfTheTubes",
              1,
              0.25F,
              {{0, -3, 0}, 0, {0, 1, 0}, infinity},
              {1.75, 2.25, 3.75, 4.25},
              ulps},
        Known{"diagonal",
              1,
              0.25F,
              {{2, 2, 0}, 0, {-1, -1, 0}, infinity},
              {2 - 1.25 / s2, 2 - 0.75 / s2, 2 + 0.75 / s2, 2 + 1.25 / s2},
              ulps},
        Known{"startsInside", 1, 0.25F, {{1, 0, 0}, 0, {1, 0, 0}, infinity}, {0.25}, ulps},
        Known{"startsInsideAndCrossesTheHole",
              1,
              0.25F,
              {{1, 0, 0}, 0, {-1, 0, 0}, infinity},
              {0.25, 1.75, 2.25},
              ulps},
        Known{"startsInTheHole", 1, 0.25F, {{0, 0, 0}, 0, {1, 0, 0}, infinity}, {0.75, 1.25}, ulps},
        Known{"behind", 1, 0.25F, {{3, 0, 0}, 0, {1, 0, 0}, infinity}, {}, ulps},
        Known{"endsBefore", 1, 0.25F, {{3, 0, 0}, 0, {-1, 0, 0}, 1.5F}, {}, ulps},
        Known{"endsInside", 1, 0.25F, {{3, 0, 0}, 0, {-1, 0, 0}, 2}, {1.75}, ulps},
        Known{"beginsInside", 1, 0.25F, {{3, 0, 0}, 2, {-1, 0, 0}, 4}, {2.25, 3.75}, ulps},
        Known{"negativeT", 1, 0.25F, {{0, 0, 0}, -2, {1, 0, 0}, 0}, {-1.25, -0.75}, ulps},
        Known{"sphere", 0, 1, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, {2, 4}, ulps},
        Known{"horn", 1, 1, {{3, 0, 0}, 0, {-1, 0, 0.5F}, infinity}, {1.2, 2.0}, ulps},
        // Celeritas issue 1126: the float32 nearest to their input; its own exact root, which is not theirs.
        Known{"celeritas",
              143,
              113.2F,
              {{160.371250F, -6.351337F, -0.000241F}, 0, {0.852793F, -0.522249F, -0.000020F}, infinity},
              {103.849236905981768},
              4e-5},
        // Along a thin tube, 5e-5 r from a tangent: two dips, and a maximum between them that float32 takes
        // for a root.
        Known{"alongAThinTube",
              1,
              0x1.0624dep-10F,
              {{0x1.4a7088p-1F, 0x1.8aa742p+1F, -0x1.ddbdd8p-8F},
               0,
               {-0x1.0284b4p-1F, -0x1.b9f07p-1F, 0x1.693412p-9F},
               infinity},
              {2.9459296205901722, 3.0031868681824414},
              ulps},
        // Out of a tube of 1e-4 R almost along its wall: 2e-8 further for 6e-15 of the tube function.
        Known{"insideAThinTube",
              1,
              0x1.a36e2ep-14F,
              {{-0x1.237172p-2F, -0x1.ead826p-1F, -0x1.8438cap-14F},
               0,
               {-0x1.eb78a8p-1F, 0x1.1f0da4p-2F, 0x1.bf797cp-12F},
               infinity},
              {0.00047562831721146897},
              1e-10},  // the library's is 1e-12 off
        // Onto the tip of a spindle's dimple, 1e-8 R beside the axis: less than a point loses that is but
        // rounded.
        Known{"ontoADimplesTip",
              1,
              1.5F,
              {{-0x1.62f74ep-1F, 0, 0x1.20ede6p+2F}, 0, {0x1.9997e4p-3F, 0, -0x1.f5a7e6p-1F}, infinity},
              {3.4665217359826599, 6.0574068736558155},
              ulps},
        // In a narrow hole, where the tube's bend along the ray is sharp: the closer the hit, the more digits
        // t has.
        Known{"closeInTheHole",
              1,
              0x1.dc28f6p-1F,
              {{-0x1.04e43p-6F, 0x1.55eebep-7F, -0x1.9762e4p-5F},
               0,
               {-0x1.947554p-1F, -0x1.da1b3cp-2F, -0x1.9ba58cp-2F},
               0.1F},
              {0.068521071596938168},
              0.75 * 0x1p-27}),  // an ulp is 2^-27
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace raytorus
