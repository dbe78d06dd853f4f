// SPDX-License-Identifier: MIT
// The last stage of the exact tier: near a crossing it is made exact, and where there is none, f and its
// slope are. Seeds are printed; RAYTORUS_SEED replays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "reference/promise.hpp"
#include "stage_rays.hpp"

namespace raytorus::test {
namespace {

using reference::Quad;
using reference::Random;

constexpr int trials = 10000;

struct Marched {
    const Trial& trial;
    StagedRay& staged;
    const LineStage& line;
    const ExactLine& exact;
    Random& random;
};

// Each fresh ray that has something left to march.
void forLines(const std::function<void(const Marched&)>& check) {
    for (int i = 0; i < trials && !testing::Test::HasFatalFailure(); ++i) {
        const Trial trial = freshTrial(static_cast<std::uint64_t>(i), 1e8);
        Random random = freshNumbers(static_cast<std::uint64_t>(i));
        const std::unique_ptr<StagedRay> staged = exactTier().reduce(trial.torus, trial.ray);
        if (staged->line().meets && staged->clip(trial.ray.tMin, trial.ray.tMax)) {
            const LineStage line = staged->line();
            staged->startMarch();
            check({trial, *staged, line, ExactLine(trial, line), random});
        }
    }
}

// The parameter that a point's two floats stand for.
Long placeOf(const PointStage& point, const LineStage& line) {
    return Long{point.shift} + Long{point.shiftLow} - Long{line.shift};
}

// The line by sums of two floats loses 2^-46 (S + D 2^-24) in a shift, S < 2 (docs/accuracy.md): in one from
// the base, and from afar in two before it.
TEST(StageRefine, APointIsTheRaysToTwoFloats) {
    forLines([&](const Marched& at) {
        const PointStage point = at.staged.pointAt(anyPlace(at.line, at.exact, at.random));
        const std::array<Long, 3> exact = at.exact.point(placeOf(point, at.line));
        const Long distance = 2 * std::abs(Long{at.line.baseShift});
        for (std::size_t k = 0; k < 3; ++k) {
            const Long off = Long{point.high[k]} + Long{point.low[k]} - exact[k];
            ASSERT_LE(std::abs(off), 3 * 0x1p-46L * (2 + distance * 0x1p-24L)) << at.trial.text();
        }
    });
}

// The error of G: that of the point, times the distances that are squared; and G's own rounding. Of the first
// twice the most that was seen.
Long roomOfTube(const ExactLine& exact, Long u) {
    const auto [x, y, z] = exact.point(u);
    const Long distances = std::abs(std::sqrt(x * x + y * y) - exact.R) + std::abs(z) + exact.r;
    return 0x1p-44L * distances * (exact.R + exact.r) + 0x1p-22L * std::abs(exact.tube(u));
}

// Near: within r / 32, where the squares nearly cancel.
TEST(StageRefine, TheTubeFunctionIsExactNearTheSurface) {
    int near = 0;
    forLines([&](const Marched& at) {
        const PointStage point = at.staged.pointAt(anyPlace(at.line, at.exact, at.random));
        const Long u = placeOf(point, at.line);
        const Long tube = at.exact.tube(u);
        if (std::abs(tube) <= at.exact.r * at.exact.r / 16) {
            ++near;
            ASSERT_LE(std::abs(Long{point.tube} - tube), roomOfTube(at.exact, u)) << at.trial.text();
        }
    });
    EXPECT_GT(near, trials / 10);
}

CrossingStage refinedFrom(StagedRay& staged, float u, float side) {
    staged.place(u, side, 8, true);
    CrossingStage crossing = staged.refine();
    for (int i = 0; i < 8 && staged.march().refines; ++i) {
        crossing = staged.refine();
    }
    return crossing;
}

void expectWithinTheBound(const Marched& at, Long root, const CrossingStage& crossing) {
    const double size = double{at.trial.torus.majorRadius} + double{at.trial.torus.minorRadius};
    const std::array<Long, 3> exact = at.exact.point(root);
    double off2 = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto off = static_cast<double>(exact[k] * Long{at.line.unit} - Long{crossing.position[k]});
        off2 += off * off;
    }
    ASSERT_LE(std::sqrt(off2), reference::positionBound * size) << at.trial.text();
    const Quad t = (Quad(root) + Quad(at.line.shift) + Quad(at.line.baseShift)) * Quad(at.line.tPerU);
    // In ulp of t, or of (R + r) / 16: half of one, where it is rounded once, and in flat crossings up to 2.
    const double least = static_cast<double>(at.exact.R + at.exact.r) * double{at.line.tPerU} / 16;
    const double magnitude = std::max(std::abs(reference::toDouble(t)), least);
    const double ulp = std::ldexp(1.0, std::ilogb(magnitude) - 23);
    ASSERT_LE(std::abs(reference::toDouble(Quad(crossing.t) - t)), 2 * ulp) << at.trial.text();
}

// From up to the march's last step, r / 64, before or behind a crossing of a clear line. One in a thousand is
// handed back at most, where a crossing is flat: the march comes nearer then.
TEST(StageRefine, ACrossingIsFoundAndTheMarchGoesOnBehindIt) {
    int found = 0;
    int handedBack = 0;
    forLines([&](const Marched& at) {
        if (at.exact.clearance < reference::clearMargin || at.exact.meetsATip()) {
            return;
        }
        float side = 1;
        for (const Long root : at.exact.roots) {
            const double part = at.random.sign() * std::pow(10.0, at.random.uniform(-4, 0)) / 64;
            const auto u = static_cast<float>(root + Long{part} * at.exact.r);
            const CrossingStage crossing = refinedFrom(at.staged, u, side);
            if (crossing.found) {
                ++found;
                expectWithinTheBound(at, root, crossing);
                const MarchStage march = at.staged.march();
                ASSERT_EQ(march.side, -side) << at.trial.text();
                // The clearance, 2^-19, but for the rounding of u.
                ASSERT_NEAR(static_cast<double>(march.u - root), 0x1p-19, 0x1p-22) << at.trial.text();
            } else {
                ++handedBack;
                ASSERT_TRUE(at.staged.march().known) << at.trial.text();
            }
            side = -side;
        }
    });
    EXPECT_GT(found, trials / 2);
    EXPECT_LE(handedBack, 10 + found / 1000);
}

// f = G (G + 4 R rho) / dd^2 has the exactness of G, and a float's rounding; h has that of its terms. Not
// beside a tip, where both terms of f vanish, and the reference's 64 bits with them.
TEST(StageRefine, WhereThereIsNoneFAndItsSlopeAreExact) {
    int handedBack = 0;
    forLines([&](const Marched& at) {
        const ExactLine& exact = at.exact;
        const float from = anyPlace(at.line, exact, at.random);
        const Long u = placeOf(at.staged.pointAt(from), at.line);
        at.staged.place(from, exact.side(u), 1, true);
        const CrossingStage crossing = at.staged.refine();
        const MarchStage march = at.staged.march();
        if (crossing.found || !march.known || exact.meetsATip()) {
            return;
        }
        ++handedBack;
        ASSERT_EQ(march.u, from) << at.trial.text();
        ASSERT_EQ(march.side, exact.side(u)) << at.trial.text();
        const auto [x, y, z] = exact.point(u);
        const Long rho = std::sqrt(x * x + y * y);
        const Long d = std::sqrt(exact.length2);
        const Long dd2 = exact.length2 * exact.length2;
        const Long tube = exact.tube(u);
        const Long a = std::abs(x * x + y * y + z * z - exact.R * exact.R - exact.r * exact.r);
        const Long middle = std::abs(tube + 2 * exact.R * rho);
        const Long ofTube = roomOfTube(exact, u);
        const Long ofF = ofTube * (2 * std::abs(tube) + 4 * exact.R * rho) / dd2 +
                         0x1p-21L * std::abs(exact.f(u)) + 0x1p-58L * exact.edge * exact.edge;
        const Long ofH =
            2 * (0x1p-21L * (a * rho + middle * std::abs(z)) + ofTube * (rho + std::abs(z))) * d / dd2;
        ASSERT_LE(std::abs(exact.f(u) - Long{march.f}), ofF)
            << fmt::format("u {:a}: ", from) << at.trial.text();
        ASSERT_LE(std::abs(exact.h(u) - Long{march.h}), ofH)
            << fmt::format("u {:a}: ", from) << at.trial.text();
    });
    EXPECT_GT(handedBack, trials / 10);
}

}  // namespace
}  // namespace raytorus::test
