// SPDX-License-Identifier: MIT
// The parabola of a step is not above f within its reach, or -f inside (math.md, eq. 30), and as near to it
// as its reach allows. Seeds are printed; RAYTORUS_SEED replays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "stage_rays.hpp"

namespace raytorus::test {
namespace {

using reference::Random;

constexpr int trials = 10000;

// The factors of f and of its derivative, by their size: what rounding is relative to.
struct Terms {
    Long a, b, c;

    Terms(const ExactLine& line, Long u) {
        const auto [x, y, z] = line.point(u);
        a = std::abs(x * x + y * y + z * z - line.R * line.R - line.r * line.r) / line.length2;
        b = std::abs(2 * line.R * z / line.length2);
        c = 2 * a + line.b1 * line.b1;
    }
};

// What rounding can make of 2 a, as march.glsl has it.
Long blurOfA(const ExactLine& exact, const LineStage& line) {
    return 1.2e-6L * (exact.R + exact.r + 2 * Long{line.farthest}) / exact.length2;
}

struct Parabola {
    const ExactLine& exact;
    const LineStage& line;
    float u, reach;
    ParabolaStage p;

    [[nodiscard]] Long at(Long x) const { return p.g + x * (2 * Long{p.s} + x * Long{p.C}); }

    // The least and the largest of (2 u + x)^2 within reach.
    [[nodiscard]] Long least() const {
        const Long from = 2 * Long{u};
        const Long to = from + Long{reach};
        return from > 0 ? from * from : (to < 0 ? to * to : 0);
    }
    [[nodiscard]] Long largest() const {
        const Long from = 2 * Long{u};
        const Long to = from + Long{reach};
        return std::max(from * from, to * to);
    }

    // Room for rounding at u + x: of a and b in f there, inherited from the foot, and some 2^-24 of each of
    // the parabola's terms. Of either twice the most that was seen.
    [[nodiscard]] Long room(Long x) const {
        const Terms here(exact, u);
        const Terms there(exact, u + x);
        const Long blur = blurOfA(exact, line);
        const Long f = here.a * here.a + here.b * here.b + exact.edge * exact.edge;
        const Long slope = 2 * x * (std::abs(2 * Long{u}) * here.a + std::abs(exact.b1) * here.b);
        const Long curve = x * x * (here.c + largest());
        return 4 * blur * (there.a + there.b + blur) + 0x1p-20L * (f + slope + curve);
    }
};

class StageParabola : public OfBothTiers {
protected:
    // From further away the fast tier's line is further from the ray's than the march is blurred.
    static double farthest() { return tier().exact ? 1e8 : 1e4; }

    // Calls check(staged, line, exact line, random, trial) for each fresh ray that has something left to
    // march.
    template <class Check>
    static void forLines(const Check& check) {
        for (int i = 0; i < trials; ++i) {
            const Trial trial = freshTrial(static_cast<std::uint64_t>(i), farthest());
            const std::unique_ptr<StagedRay> staged = tier().reduce(trial.torus, trial.ray);
            if (staged->line().meets && staged->clip(trial.ray.tMin, trial.ray.tMax)) {
                const LineStage line = staged->line();
                staged->startMarch();
                check(*staged, line, ExactLine(trial, line), freshNumbers(static_cast<std::uint64_t>(i)),
                      trial);
                if (HasFatalFailure()) {
                    return;
                }
            }
        }
    }
};

// Of either side of the tube, wherever the place is: eq. 30 asks for neither. So near that no parabola with
// the same value and slope, and the same reach, is nearer by more than what (2 u + x)^2 changes.
TEST_P(StageParabola, IsNotAboveFAndNear) {
    int judged = 0;
    forLines([&](StagedRay& staged, const LineStage& line, const ExactLine& exact, Random random,
                 const Trial& trial) {
        for (const float side : {1.0F, -1.0F}) {
            const auto reach = static_cast<float>(8 * std::pow(10.0, random.uniform(-6, 0)));
            const float u = anyPlace(line, exact, random);
            staged.place(u, side, reach, false);
            const Parabola parabola{exact, line, u, reach, staged.parabola()};
            for (int n = 0; n < 8; ++n) {
                const Long part = n < 4 ? n / 3.0L : std::pow(2.0L, Long{random.uniform(-20, 0)});
                const Long x = part * Long{reach};
                const Long above = Long{side} * exact.f(u + x) - parabola.at(x);
                const Long change = (parabola.largest() - parabola.least()) * x * x;
                const Long room = parabola.room(x);
                ++judged;
                ASSERT_GE(above, -room) << fmt::format("side {} u {:a} reach {:a} x {} of it: ", side, u,
                                                       reach, static_cast<double>(part))
                                        << trial.text();
                // Where it rises its curvature is taken as small as rounding can have made it.
                const Long lowered = 1.01L * blurOfA(exact, line) * x * x;
                ASSERT_LE(above, change + room + lowered)
                    << fmt::format("side {} u {:a} reach {:a} x {} of it: ", side, u, reach,
                                   static_cast<double>(part))
                    << trial.text();
            }
        }
    });
    EXPECT_GT(judged, trials);
}

// Near the surface, where |a| is e at most, f is right to the blur that the march has of it, and that is no
// larger than march.glsl says.
TEST_P(StageParabola, BlurIsWhatRoundingMakesOfF) {
    int judged = 0;
    forLines([&](StagedRay& staged, const LineStage& line, const ExactLine& exact, Random random,
                 const Trial& trial) {
        const Long ofA = blurOfA(exact, line);
        const auto blur = Long{staged.blur()};
        ASSERT_LE(blur, 1.00001L * ofA * (exact.edge + ofA)) << trial.text();
        for (int n = 0; n < 4; ++n) {
            const float u = anyPlace(line, exact, random);
            if (Terms(exact, u).a <= exact.edge) {
                ++judged;
                staged.place(u, 1, 1, false);
                ASSERT_LE(std::abs(exact.f(u) - Long{staged.parabola().g}), blur)
                    << fmt::format("u {:a}: ", u) << trial.text();
            }
        }
    });
    EXPECT_GT(judged, trials / 2);
}

INSTANTIATE_TEST_SUITE_P(Tier, StageParabola, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
