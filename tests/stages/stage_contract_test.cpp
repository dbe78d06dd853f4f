// SPDX-License-Identifier: MIT
// What is no ray, by the rules at the head of torus.glsl: the reduction sorts it out, and lets the rest pass.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "stage_rays.hpp"
#include "support/special_floats.hpp"

namespace raytorus::test {
namespace {

using reference::Ray;
using reference::Torus;

constexpr float largest = std::numeric_limits<float>::max();
constexpr float least = std::numeric_limits<float>::denorm_min();

// A ray along -x through the whole of a torus.
Trial sound() {
    return {{1, 0.25F}, {{3, 0, 0}, 0, {-1, 0, 0}, 100}};
}

class StageContract : public OfBothTiers {
protected:
    static bool meets(const Trial& trial) { return tier().reduce(trial.torus, trial.ray)->line().meets; }

    template <class Change>
    static void expectNone(const std::string& what, const Change& change) {
        Trial trial = sound();
        change(trial);
        EXPECT_FALSE(meets(trial)) << what << ": " << trial.text();
    }

    template <class Change>
    static void expectSome(const std::string& what, const Change& change) {
        Trial trial = sound();
        change(trial);
        EXPECT_TRUE(meets(trial)) << what << ": " << trial.text();
    }
};

TEST_P(StageContract, NoRadiusIsNegativeAndTheTubeHasOne) {
    EXPECT_TRUE(meets(sound()));
    for (const float r : {0.0F, -0.0F, -least, -0.25F, -1.0F, -largest}) {
        expectNone("r", [r](Trial& t) { t.torus.minorRadius = r; });
    }
    for (const float R : {-least, -0.125F, -1.0F, -largest}) {
        expectNone("R", [R](Trial& t) { t.torus.majorRadius = R; });
    }
    for (const float R : {0.0F, -0.0F, least}) {
        // A sphere.
        expectSome("R", [R](Trial& t) { t.torus = {R, 1}; });
    }
}

TEST_P(StageContract, NothingIsInfiniteOrNan) {
    for (const float bad : {nan, -nan, infinity, -infinity}) {
        expectNone("R", [bad](Trial& t) { t.torus.majorRadius = bad; });
        expectNone("r", [bad](Trial& t) { t.torus.minorRadius = bad; });
        expectNone("R and r", [bad](Trial& t) { t.torus = {bad, bad}; });
        for (std::size_t i = 0; i < 3; ++i) {
            expectNone("origin", [=](Trial& t) { t.ray.origin[i] = bad; });
            expectNone("direction", [=](Trial& t) { t.ray.direction[i] = bad; });
            expectNone("both", [=](Trial& t) { t.ray.origin[i] = t.ray.direction[i] = bad; });
        }
    }
    expectNone("R and r overflow", [](Trial& t) { t.torus = {0.75F * largest, 0.75F * largest}; });
}

TEST_P(StageContract, TheDirectionIsNotZero) {
    for (const float x : {0.0F, -0.0F, least, -least}) {
        expectNone("direction", [x](Trial& t) { t.ray.direction[0] = x; });
        // The origin being the centre, the foot is sound.
        expectNone("direction at the centre", [x](Trial& t) { t.ray = {{0, 0, 0}, 0, {x, -x, x}, 1}; });
    }
}

TEST_P(StageContract, TheRaysEndsAreInOrder) {
    expectNone("tMin > tMax", [](Trial& t) { t.ray.tMin = std::nextafter(t.ray.tMax, infinity); });
    expectNone("tMin infinite", [](Trial& t) { t.ray.tMin = infinity; });
    expectNone("tMax infinite below", [](Trial& t) { t.ray.tMax = -infinity; });
    expectNone("tMin nan", [](Trial& t) { t.ray.tMin = nan; });
    expectNone("tMax nan", [](Trial& t) { t.ray.tMax = nan; });
    expectNone("both nan", [](Trial& t) { t.ray.tMin = t.ray.tMax = nan; });
    expectSome("equal", [](Trial& t) { t.ray.tMin = t.ray.tMax; });
    expectSome("zeros", [](Trial& t) { t.ray.tMin = 0.0F, t.ray.tMax = -0.0F; });
    expectSome("infinite", [](Trial& t) { t.ray.tMin = -infinity, t.ray.tMax = infinity; });
}

bool meetsOfSize(const Tier& tier, float majorRadius, float minorRadius) {
    const float start = majorRadius + minorRadius;
    const Ray ray{{start, 0, 0}, 0, {-1, 0, 0}, infinity};
    return tier.reduce({majorRadius, minorRadius}, ray)->line().meets;
}

// Promised from 1e-18 to 1e18. A size or length beyond the powers of two that hold these is none.
TEST_P(StageContract, SizesAreWithinTheirLimits) {
    for (const float size : {0x1p-60F, 1e-18F, 1e18F, std::nextafter(0x1p60F, 0.0F)}) {
        EXPECT_TRUE(meetsOfSize(tier(), 0, size)) << size;
        // The size is the sum.
        EXPECT_TRUE(meetsOfSize(tier(), size / 2, size / 2)) << size;
    }
    for (const float size : {std::nextafter(0x1p-60F, 0.0F), 1e-19F, least, 0x1p60F, 1e19F, largest}) {
        EXPECT_FALSE(meetsOfSize(tier(), 0, size)) << size;
    }
    EXPECT_FALSE(meetsOfSize(tier(), 0x1p59F, 0x1p59F));
}

TEST_P(StageContract, DirectionsAreWithinTheirLimits) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto along = [i](float length) {
            Trial trial = sound();
            trial.ray = {{0.5F, 0.5F, 0}, -infinity, {0, 0, 0}, infinity};
            trial.ray.direction[i] = length;
            return trial;
        };
        for (const float sign : {1.0F, -1.0F}) {
            for (const float length : {0x1p-63F, 1e-18F, 1e18F, std::nextafter(0x1p64F, 0.0F)}) {
                EXPECT_TRUE(meets(along(sign * length))) << fmt::format("{} {}", i, sign * length);
            }
            for (const float length : {std::nextafter(0x1p-63F, 0.0F), 1e-20F, 0x1p64F, 1e20F, largest}) {
                EXPECT_FALSE(meets(along(sign * length))) << fmt::format("{} {}", i, sign * length);
            }
        }
    }
    // A direction of 1e-18 has components of 0.57e-18.
    const float part = 1e-18F / std::sqrt(3.0F);
    expectSome("diagonal", [part](Trial& t) { t.ray = {{0, 0, 0}, 0, {part, part, part}, infinity}; });
}

INSTANTIATE_TEST_SUITE_P(Tier, StageContract, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
