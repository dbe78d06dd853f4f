// SPDX-License-Identifier: MIT
// The first stage: a ray's line in units of the torus, counted from its foot. Seeds are printed;
// RAYTORUS_SEED replays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "stage_rays.hpp"

namespace raytorus::test {
namespace {

using reference::Quad;

constexpr int trials = 10000;

// How far base + baseLow is from the point of the ray that it stands for, in units: of the worst coordinate.
double baseError(const Trial& trial, const LineStage& line) {
    const Quad directionUnit = Quad(line.uPerT) * Quad(line.unit);
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Quad exact = Quad(trial.ray.origin[i]) / Quad(line.unit) +
                           Quad(line.baseShift) * (Quad(trial.ray.direction[i]) / directionUnit);
        const Quad off = Quad(line.base[i]) + Quad(line.baseLow[i]) - exact;
        worst = std::max(worst, std::abs(reference::toDouble(off)));
    }
    return worst;
}

// How far the origin is, in units.
double distanceOf(const Trial& trial, const LineStage& line) {
    double largest = 0;
    for (const float x : trial.ray.origin) {
        largest = std::max(largest, std::abs(double{x} / double{line.unit}));
    }
    return largest;
}

class StageReduce : public OfBothTiers {};

// A near origin is the base itself. From afar each of two moves loses the rounding of its errors' sum, 2^-46
// (S + D 2^-24) (docs/accuracy.md), where S < 2. The fast tier's one move rounds two sums of numbers about as
// large as the base, each to half an ulp.
TEST_P(StageReduce, TheLinesPointsAreTheRays) {
    int far = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), 1e8);
        const LineStage line = tier().reduce(trial.torus, trial.ray)->line();
        const double distance = distanceOf(trial, line);
        const bool isFar = distance > 8;
        far += isFar ? 1 : 0;
        const double exactBound = isFar ? 0x1p-45 * (2 + distance * 0x1p-24) : 0.0;
        const double fastBound = 0x1p-22 * std::max(1.0, double{line.farthest});
        ASSERT_LE(baseError(trial, line), tier().exact ? exactBound : fastBound) << trial.text();
        for (std::size_t k = 0; k < 3; ++k) {
            // Both sides are exact: powers of two.
            ASSERT_EQ(double{line.direction[k]} * double{line.unit},
                      double{trial.ray.direction[k]} * double{line.tPerU})
                << trial.text();
        }
        ASSERT_EQ(line.tPerU * line.uPerT, 1.0F) << trial.text();
    }
    EXPECT_GT(far, trials / 4);
}

// The foot's sum rounds once, the product in it once: 2^-23 of the base. So does what makes up the shift, of
// three products.
TEST_P(StageReduce, TheFootIsTheNearestPointToRounding) {
    int meet = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), 1e8);
        const LineStage line = tier().reduce(trial.torus, trial.ray)->line();
        if (!line.meets) {
            continue;
        }
        ++meet;
        const std::array<Long, 3> foot = ExactLine(trial, line).point(0);
        const double scale = std::max(1.0, double{line.farthest});
        double along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Long off = foot[k] - Long{line.foot[k]};
            ASSERT_LE(std::abs(static_cast<double>(off)), 0x1p-22 * scale) << trial.text();
            along += static_cast<double>(foot[k] * Long{line.direction[k]});
        }
        ASSERT_LE(std::abs(along) / std::sqrt(double{line.length2}), 0x1p-21 * scale) << trial.text();
    }
    EXPECT_GT(meet, trials / 2);
}

// Near: the rounding of the foot is that of the base. The fast tier's parameter has 12 bits, which leaves
// 2^-11 of the way.
TEST_P(StageReduce, TheBaseIsNear) {
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), 1e8);
        const LineStage line = tier().reduce(trial.torus, trial.ray)->line();
        const double distance = distanceOf(trial, line);
        const double exactBound = 8 + 0x1p-24 * distance;
        const double fastBound = 2 + 0x1p-11 * distance;
        if (line.meets) {
            ASSERT_LE(double{line.farthest}, tier().exact ? exactBound : fastBound) << trial.text();
        }
    }
}

// All but the unit and t's factors, as the rows of a table.
std::vector<float> unitless(const LineStage& line) {
    std::vector<float> all{line.majorRadius, line.minorRadius, line.baseShift, line.shift,
                           line.length2,     line.farthest,    line.lower,     line.upper};
    for (const FloatVec3& v : {line.base, line.baseLow, line.direction, line.foot}) {
        all.insert(all.end(), v.begin(), v.end());
    }
    all.insert(all.end(), {line.meets ? 1.0F : 0.0F, line.fromStart ? 1.0F : 0.0F});
    return all;
}

LineStage clipped(const Tier& tier, const Trial& trial) {
    const std::unique_ptr<StagedRay> staged = tier.reduce(trial.torus, trial.ray);
    if (staged->line().meets) {
        staged->clip(trial.ray.tMin, trial.ray.tMax);
    }
    return staged->line();
}

TEST_P(StageReduce, ScalingByPowersOfTwoChangesNoBit) {
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), 1e4);
        reference::Random random = freshNumbers(static_cast<std::uint64_t>(i));
        const LineStage line = clipped(tier(), trial);
        // Directions have every length already: one step up or down from 2^0. Sizes are near 1.
        const int size = random.below(80) - 40;
        const int speed = line.uPerT * line.unit < 1 ? random.below(40) : -random.below(40);
        Trial scaled = trial;
        scaled.torus = {std::ldexp(trial.torus.majorRadius, size), std::ldexp(trial.torus.minorRadius, size)};
        for (std::size_t k = 0; k < 3; ++k) {
            scaled.ray.origin[k] = std::ldexp(trial.ray.origin[k], size);
            scaled.ray.direction[k] = std::ldexp(trial.ray.direction[k], speed);
        }
        scaled.ray.tMin = std::ldexp(trial.ray.tMin, size - speed);
        scaled.ray.tMax = std::ldexp(trial.ray.tMax, size - speed);
        const LineStage other = clipped(tier(), scaled);
        const std::vector<float> expected = unitless(line);
        const std::vector<float> found = unitless(other);
        ASSERT_EQ(std::memcmp(expected.data(), found.data(), expected.size() * sizeof(float)), 0)
            << trial.text() << fmt::format(" scaled by 2^{}, its direction by 2^{}", size, speed);
        ASSERT_EQ(other.unit, std::ldexp(line.unit, size)) << trial.text();
        ASSERT_EQ(other.tPerU, std::ldexp(line.tPerU, size - speed)) << trial.text();
    }
}

INSTANTIATE_TEST_SUITE_P(Tier, StageReduce, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
