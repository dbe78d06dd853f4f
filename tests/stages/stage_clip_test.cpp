// SPDX-License-Identifier: MIT
// The second stage: what is left of the line holds every crossing of the ray, and little more than where the
// torus can be. Seeds are printed; RAYTORUS_SEED replays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "stage_rays.hpp"
#include "support/special_floats.hpp"

namespace raytorus::test {
namespace {

using reference::Quad;
using reference::Random;

constexpr int trials = 10000;

// A crossing at the ray's very start may be lost to the rounding of u there: two sums of numbers below 4.
constexpr double startRounding = 0x1p-21;

class StageClip : public OfBothTiers {
protected:
    // From further away the fast tier's base is further from the foot than the exact tier's 8 units, which
    // the padding is for.
    static double farthest() { return tier().exact ? 1e8 : 1e4; }
};

// Moves an end of the ray to a crossing, or up to three floats beside it.
void endAtACrossing(Trial& trial, const LineStage& line, const ExactLine& exact, Random& random) {
    if (exact.roots.empty()) {
        return;
    }
    const Long u = exact.roots[static_cast<std::size_t>(random.below(static_cast<int>(exact.roots.size())))];
    const Quad t = (Quad(u) + Quad(line.shift) + Quad(line.baseShift)) * Quad(line.tPerU);
    auto end = static_cast<float>(t);
    for (int steps = random.below(4); steps > 0; --steps) {
        end = std::nextafter(end, random.below(2) == 0 ? infinity : -infinity);
    }
    const bool atStart = random.below(2) == 0;
    trial.ray.tMin = atStart ? end : -infinity;
    trial.ray.tMax = atStart ? infinity : end;
}

// Where the line enters the sphere and what is between the planes, each padded by so much, and where it
// leaves them.
struct Bounds {
    double enter, leave;
};
Bounds boundsOf(const ExactLine& exact, double sphere, double planes) {
    const auto outer = static_cast<double>(exact.R + exact.r);
    const auto half = static_cast<double>(exact.r) + planes;
    const auto length2 = static_cast<double>(exact.length2);
    const auto foot2 = static_cast<double>(exact.foot2);
    const double chord = std::sqrt(std::max(outer * outer * (1 + sphere) - foot2, 0.0) / length2);
    const auto rise = static_cast<double>(exact.direction[2]);
    const double middle = -static_cast<double>(exact.foot[2]) / (rise + std::copysign(1e-30, rise));
    const double slab = half / (std::abs(rise) + 1e-30);
    return {std::max(-chord, middle - slab), std::min(chord, middle + slab)};
}

TEST_P(StageClip, EveryCrossingOfTheRayIsLeft) {
    int crossings = 0;
    for (int i = 0; i < trials; ++i) {
        Trial trial = freshTrial(static_cast<std::uint64_t>(i), farthest());
        Random random = freshNumbers(static_cast<std::uint64_t>(i));
        const std::unique_ptr<StagedRay> staged = tier().reduce(trial.torus, trial.ray);
        const ExactLine exact(trial, staged->line());
        if (!staged->line().meets) {
            ASSERT_TRUE(exact.roots.empty()) << trial.text();
            continue;
        }
        if (i % 2 == 0) {
            endAtACrossing(trial, staged->line(), exact, random);
        }
        const bool left = staged->clip(trial.ray.tMin, trial.ray.tMax);
        const LineStage line = staged->line();
        const Long begin = parameterOf(line, Quad(trial.ray.tMin));
        const Long end = parameterOf(line, Quad(trial.ray.tMax));
        for (const Long u : exact.roots) {
            if (u >= begin && u <= end) {
                ++crossings;
                ASSERT_TRUE(left) << trial.text();
                ASSERT_GE(static_cast<double>(u), double{line.lower} - startRounding) << trial.text();
                ASSERT_LE(static_cast<double>(u), double{line.upper}) << trial.text();
            }
        }
    }
    EXPECT_GT(crossings, trials / 2);
}

// So that clipping is worth its while: to sphere, planes and ray, with twice the padding that they have.
TEST_P(StageClip, LittleElseIsLeft) {
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), farthest());
        const std::unique_ptr<StagedRay> staged = tier().reduce(trial.torus, trial.ray);
        if (!staged->line().meets) {
            continue;
        }
        const ExactLine exact(trial, staged->line());
        const bool left = staged->clip(trial.ray.tMin, trial.ray.tMax);
        const LineStage line = staged->line();
        const Bounds padded = boundsOf(exact, 4e-5, 1.2e-5);
        const auto begin = static_cast<double>(parameterOf(line, Quad(trial.ray.tMin)));
        const auto end = static_cast<double>(parameterOf(line, Quad(trial.ray.tMax)));
        const double from = std::max(padded.enter, begin) - 1e-5;
        const double to = std::min(padded.leave, end) + 2e-5;
        // Foot and middle of the planes are rounded, the latter by a part of itself.
        const double blur = 1e-6 * (1 + std::abs(from) + std::abs(to));
        if (left) {
            ASSERT_GE(double{line.lower}, from - blur) << trial.text();
            ASSERT_LE(double{line.upper}, to + blur) << trial.text();
        } else {
            const Bounds bare = boundsOf(exact, 0, 0);
            ASSERT_GE(std::max(bare.enter, begin), std::min(bare.leave, end) - blur) << trial.text();
        }
    }
}

// The ray's start cuts what the torus can be in, or lies before it. Between the bare and the padded bounds
// either is right.
TEST_P(StageClip, FromStartSaysWhetherTheStartCuts) {
    int cuts = 0;
    int lies = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), farthest());
        const std::unique_ptr<StagedRay> staged = tier().reduce(trial.torus, trial.ray);
        if (!staged->line().meets || !staged->clip(trial.ray.tMin, trial.ray.tMax)) {
            continue;
        }
        const LineStage line = staged->line();
        const ExactLine exact(trial, line);
        const auto begin = static_cast<double>(parameterOf(line, Quad(trial.ray.tMin)));
        if (begin > boundsOf(exact, 0, 0).enter + 1e-5) {
            ++cuts;
            ASSERT_TRUE(line.fromStart) << trial.text();
        } else if (begin < boundsOf(exact, 4e-5, 1.2e-5).enter - 1e-5) {
            ++lies;
            ASSERT_FALSE(line.fromStart) << trial.text();
        }
    }
    EXPECT_GT(cuts, trials / 20);
    EXPECT_GT(lies, trials / 20);
}

INSTANTIATE_TEST_SUITE_P(Tier, StageClip, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
