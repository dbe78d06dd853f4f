// SPDX-License-Identifier: MIT
// explain(): the shaders' side is what the tracer says, special positions are named, bad input is explained.
#include "explain/explain.hpp"

#include <cmath>
#include <cstring>

#include "explain/conclusion.hpp"
#include "explain/number_text.hpp"
#include "explain/text.hpp"
#include "reference/rays.hpp"
#include "support/device_fixture.hpp"
#include "support/fresh_seed.hpp"
#include "support/special_floats.hpp"
#include "trace/tracer.hpp"

namespace raytorus::test {
namespace {

using explain::Explanation;
using explain::RootCase;
using reference::Ray;
using reference::Torus;

constexpr Torus ring{1.0F, 0.25F};

class Explain : public DeviceTest {
protected:
    static Explanation of(const Torus& torus, const Ray& ray) {
        return explain::explain(device(), torus, ray);
    }
};

TEST_F(Explain, TheHitsAreTheTracersBitByBit) {
    trace::Tracer tracer(device(), trace::Query::All, 1);
    for (const reference::RayClass rayClass : reference::allRayClasses) {
        reference::RayParameters parameters;
        parameters.seed = freshSeed();
        for (std::uint64_t i = 0; i < 2; ++i) {
            SCOPED_TRACE(reference::describeRay(rayClass, parameters, i));
            const Ray ray = reference::generateRay(rayClass, parameters, i).ray;
            const Explanation e = of(parameters.torus, ray);
            trace::TraceRay traced{};
            std::memcpy(&traced, &ray, sizeof(ray));
            trace::AllHits all{};
            std::memcpy(&all, tracer.trace({1.0F, 0.25F}, {&traced, 1}).data(), sizeof(all));
            ASSERT_EQ(static_cast<float>(e.hits.size()), all.count);
            for (std::size_t k = 0; k < e.hits.size(); ++k) {
                EXPECT_EQ(e.hits[k].t, all.t[k]);
                EXPECT_EQ(std::memcmp(e.hits[k].position.data(), all.position[k], sizeof(all.position[k])),
                          0);
            }
            EXPECT_TRUE(e.agree);
            if (e.clearance > 1e-3 && e.startClearance > 1e-3 && e.stopClearance > 1e-3) {
                EXPECT_TRUE(explain::isRight(e)) << explain::textOf(e);
            }
        }
    }
}

// What float32 makes of exact numbers, within what the roundings of a handful of steps can do.
TEST_F(Explain, TheStepsAreTheExactOnesRounded) {
    const Explanation e = of(ring, {{-3.0F, 0.3F, 0.2F}, 0.0F, {1.0F, 0.1F, -0.05F}, infinity});
    ASSERT_TRUE(e.shader.reduced && e.exact.reduced);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_LT(explain::ulpError(e.shader.coefficients[i], e.exact.coefficients[i]), 16.0) << "c" << i;
    }
    EXPECT_LT(explain::ulpError(e.shader.alpha, e.exact.alpha), 16.0);
    EXPECT_LT(explain::ulpError(e.shader.alphaRadial, e.exact.alpha), 16.0);
    EXPECT_LT(explain::ulpError(e.shader.beta, e.exact.beta), 16.0);
    EXPECT_LT(explain::ulpError(e.shader.betaSum, e.exact.beta), 64.0);
    EXPECT_LT(explain::ulpError(e.shader.gamma, e.exact.gamma), 64.0);
    EXPECT_LT(explain::ulpError(e.shader.delta, e.exact.delta), 64.0);
    EXPECT_LT(explain::ulpError(e.shader.y, e.exact.y), 64.0);
    EXPECT_LT(explain::ulpError(e.shader.S, e.exact.S), 64.0);
    EXPECT_EQ(e.shader.rootCase, RootCase::FourOrNone);
    EXPECT_EQ(e.exact.rootCase, RootCase::FourOrNone);
    EXPECT_FALSE(e.shader.zeta || e.exact.zeta);
    EXPECT_EQ(e.closedForm.size(), 4U);
    EXPECT_LT(e.closedForms.position, 1e-5);
    ASSERT_EQ(e.roots.size(), 4U);
    for (const explain::TrueRoot& root : e.roots) {
        ASSERT_TRUE(root.hit && root.closedForm);
        const explain::ShaderHit& hit = e.hits[*root.hit];
        EXPECT_LT(explain::tError(e, root, hit.t), 2.0);
        EXPECT_LT(explain::positionError(e, root, hit.position), 9e-8);
        // The position's error, which is that of 1.25, on a tube of 0.25, and as much again for the
        // functions' own.
        EXPECT_LT(explain::normalError(root, hit), 1e-6);
        EXPECT_LT(explain::uvError(root, hit), 1e-6);
    }
    ASSERT_TRUE(e.nearest);
    EXPECT_EQ(e.nearest->normal, e.hits[0].normal);
    EXPECT_EQ(e.nearest->uv, e.hits[0].uv);
}

struct Special {
    const char* name;
    Torus torus;
    Ray ray;
    const char* note;
    std::size_t hits;
};

void PrintTo(const Special& row, std::ostream* out) {
    *out << row.name;
}

class ExplainSpecial : public Explain, public testing::WithParamInterface<Special> {};

TEST_P(ExplainSpecial, IsNoted) {
    const Special& special = GetParam();
    const Explanation e = of(special.torus, special.ray);
    std::string notes;
    for (const std::string& note : e.notes) {
        notes += note + "\n";
    }
    EXPECT_NE(notes.find(special.note), std::string::npos) << notes;
    EXPECT_EQ(e.hits.size(), special.hits);
    EXPECT_TRUE(e.faults.empty());
    EXPECT_TRUE(explain::isRight(e)) << explain::textOf(e);
}

const Special specials[] = {
    {"Parallel", ring, {{0.9F, 0, 3}, 0, {0, 0, -1}, infinity}, "parallel to the axis", 2},
    {"Equatorial", ring, {{-3, 0.1F, 0}, 0, {1, 0, 0}, infinity}, "in the equatorial plane", 4},
    {"Perpendicular", ring, {{-3, 0.1F, 0.1F}, 0, {1, 0, 0}, infinity}, "perpendicular to the axis", 4},
    {"Centre", ring, {{-3, 0, 0.3F}, 0, {3, 0, -0.3F}, infinity}, "passes through the centre", 4},
    {"Axis", ring, {{-3, 0, 0.5F}, 0, {1, 0, 0}, infinity}, "the centre at 0.5 R, meets the axis", 0},
    {"Inside", ring, {{1, 0, 0}, 0, {1, 0, 0.1F}, infinity}, "starts inside the solid", 1},
    {"Length", ring, {{1, 0, 3}, 0, {0, 0, -4}, infinity}, "the direction is 4 long", 2},
    {"Far", ring, {{1e6F, 0, 0}, 0, {-1, 0, 0}, infinity}, "starts 8e+05 (R + r) away", 4},
    {"Tangent", ring, {{-3, 1.24999F, 0}, 0, {1, 0, 0}, infinity}, "nearly tangent", 2},
    {"AtStart",
     ring,
     {{1.25F, 0, 0}, 0, {1, 0, 0.1F}, infinity},
     "at tMin the ray is 0 r from the surface",
     0},  // it leaves: a hit exactly at an end may go either way
    {"Sphere", {0, 1}, {{3, 0, 0.1F}, 0, {-1, 0, 0}, infinity}, "R = 0, a sphere", 2},
    {"NearlyASphere", {0.001F, 1}, {{3, 0, 0.1F}, 0, {-1, 0, 0}, infinity}, "r > 100 R", 2},
    {"Past", ring, {{3, 0, 2}, 0, {-1, 0, 0}, infinity}, "passes the bounding sphere by", 0},
    {"Spindle", {1, 1.5F}, {{4, 0, 0.1F}, 0, {-1, 0, 0}, infinity}, "roots on the inner one are no hits", 2},
};

INSTANTIATE_TEST_SUITE_P(Rays, ExplainSpecial, testing::ValuesIn(specials),
                         [](const testing::TestParamInfo<Special>& row) { return row.param.name; });

struct Bad {
    const char* name;
    Torus torus;
    Ray ray;
    const char* fault;
};

void PrintTo(const Bad& row, std::ostream* out) {
    *out << row.name;
}

class ExplainBadInput : public Explain, public testing::WithParamInterface<Bad> {};

TEST_P(ExplainBadInput, IsNamedAndHasNoHit) {
    const Explanation e = of(GetParam().torus, GetParam().ray);
    ASSERT_EQ(e.faults.size(), 1U);
    EXPECT_EQ(e.faults[0], GetParam().fault);
    EXPECT_TRUE(e.roots.empty() && e.hits.empty() && !e.nearest && !e.occluded);
    EXPECT_EQ(e.conclusion, "the library is right: no hit for bad input");
    EXPECT_NE(explain::textOf(e).find(e.faults[0]), std::string::npos);
}

const Bad badInput[] = {
    {"NoTube", {1, 0}, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, "r = 0 is not positive"},
    {"NegativeTube", {1, -0.5F}, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, "r = -0.5 is not positive"},
    {"NegativeRing", {-1, 0.5F}, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, "R = -1 is negative"},
    {"InfiniteRadius", {infinity, 1}, {{3, 0, 0}, 0, {-1, 0, 0}, infinity}, "a radius is not finite"},
    {"OriginNan", ring, {{nan, 0, 0}, 0, {-1, 0, 0}, infinity}, "the origin is not finite"},
    {"DirectionInfinite", ring, {{3, 0, 0}, 0, {-infinity, 0, 0}, infinity}, "the direction is not finite"},
    {"NoDirection", ring, {{3, 0, 0}, 0, {0, -0.0F, 0}, infinity}, "the direction is zero"},
    {"Backwards", ring, {{3, 0, 0}, 2, {-1, 0, 0}, 1}, "tMin is greater than tMax"},
    {"EndNan", ring, {{3, 0, 0}, 0, {-1, 0, 0}, nan}, "tMin or tMax is no number"},
    {"Huge",
     {1e18F, 1e18F},
     {{3, 0, 0}, 0, {-1, 0, 0}, infinity},
     "R + r = 2e+18 is not from 1e-18 to 1e+18"},
    {"Slow",
     ring,
     {{3, 0, 0}, 0, {-1e-20F, 0, 0}, infinity},
     "the direction is 1e-20 long, not 1e-18 to 1e18"},
};

INSTANTIATE_TEST_SUITE_P(Inputs, ExplainBadInput, testing::ValuesIn(badInput),
                         [](const testing::TestParamInfo<Bad>& row) { return row.param.name; });

}  // namespace
}  // namespace raytorus::test
