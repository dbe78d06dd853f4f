// SPDX-License-Identifier: MIT
// The march's steps against the reference's crossings: from wherever, inside or out, none is passed. Seeds
// are printed; RAYTORUS_SEED replays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "stage_rays.hpp"
#include "support/special_floats.hpp"

namespace raytorus::test {
namespace {

using reference::Quad;
using reference::Random;

constexpr int trials = 10000;

// The fast tier's shortest step, in r, and a little for its rounding.
constexpr Long shortestStep = 1.02L / 1024;

// What a step from here to there went over.
struct Passed {
    int count = 0;
    Long depth =
        0;  // the largest |f| on the far side, at the middles between crossings and where the step ended
};

Passed passedBy(const ExactLine& exact, Long from, Long to) {
    Passed passed;
    Long last = 0;
    for (const Long root : exact.roots) {
        if (root <= from || root > to) {
            continue;
        }
        if (passed.count % 2 == 1) {
            passed.depth = std::max(passed.depth, std::abs(exact.f((last + root) / 2)));
        }
        last = root;
        ++passed.count;
    }
    if (passed.count % 2 == 1) {
        passed.depth = std::max(passed.depth, std::abs(exact.f(to)));
    }
    return passed;
}

struct Step {
    const Trial& trial;
    const ExactLine& exact;
    const LineStage& line;
    float from, side, reach;
    Long blur;
    MarchStage after;

    [[nodiscard]] std::string text() const {
        return fmt::format("side {} u {:a} reach {:a} next {:a}: ", side, from, reach, after.u) +
               trial.text();
    }
};

// Half of the rays end 1e-7 to 0.1 of r before or behind a crossing.
void endNearACrossing(Trial& trial, const LineStage& line, const ExactLine& exact, Random& random) {
    if (!exact.roots.empty() && random.below(2) == 0) {
        const int root = random.below(static_cast<int>(exact.roots.size()));
        const double off = random.sign() * std::pow(10.0, random.uniform(-7, -1));
        const Quad end = Quad(exact.roots[static_cast<std::size_t>(root)]) + Quad(off) * Quad(exact.r);
        trial.ray.tMax =
            static_cast<float>((end + Quad(line.shift) + Quad(line.baseShift)) * Quad(line.tPerU));
    }
}

class StageStep : public OfBothTiers {
protected:
    // From further away the fast tier's line is further from the ray's than the march is blurred.
    static double farthest() { return tier().exact ? 1e8 : 1e4; }

    // A step is one of the march: what stands for it is a search of one.
    static void takeSteps(const Trial& trial, StagedRay& staged, const ExactLine& exact, Random& random,
                          const std::function<void(const Step&)>& check) {
        const LineStage line = staged.line();
        staged.startMarch();
        const Long blur{staged.blur()};
        for (int n = 0; n < 6; ++n) {
            const float u = anyPlace(line, exact, random);
            const float side = exact.side(u);
            // The march begins with these, and its reach shrinks from there.
            const double longest = side < 0 ? 2 * double{line.minorRadius} : 8.0;
            const double part = n % 2 == 0 ? 1.0 : std::pow(10.0, random.uniform(-6, 0));
            const auto reach = static_cast<float>(longest * part);
            // On the surface there is no side to begin with.
            if (std::abs(exact.f(u)) > 2 * blur) {
                staged.place(u, side, reach, false);
                staged.search(1);
                check({trial, exact, line, u, side, reach, blur, staged.march()});
            }
        }
    }

    static void forSteps(const std::function<void(const Step&)>& check) {
        for (int i = 0; i < trials && !HasFatalFailure(); ++i) {
            Trial trial = freshTrial(static_cast<std::uint64_t>(i), farthest());
            Random random = freshNumbers(static_cast<std::uint64_t>(i));
            const std::unique_ptr<StagedRay> staged = tier().reduce(trial.torus, trial.ray);
            const ExactLine exact(trial, staged->line());
            if (!staged->line().meets || (!tier().exact && exact.meetsATip())) {
                continue;
            }
            endNearACrossing(trial, staged->line(), exact, random);
            if (staged->clip(trial.ray.tMin, trial.ray.tMax)) {
                takeSteps(trial, *staged, exact, random, check);
            }
        }
    }
};

// By rounding a step may end just behind a crossing, the fast tier's shortest step a little further: the next
// step is on the wrong side then, and the refinement finds it. A pair of crossings would be lost. The exact
// tier passes none unless it asks for a refinement; the fast tier those of a dip that rounding hides.
TEST_P(StageStep, PassesNoCrossing) {
    int steps = 0;
    int refinements = 0;
    forSteps([&](const Step& step) {
        ++steps;
        refinements += step.after.refines ? 1 : 0;
        // Where it ends the line by what is left of it, u may lose an ulp.
        ASSERT_GE(double{step.after.u}, double{step.from} - 0x1p-22) << step.text();
        const Long shortest = tier().exact ? 0 : shortestStep * step.exact.r;
        const Passed passed = passedBy(step.exact, step.from, step.after.u - shortest);
        // The roundings of f at both ends of the step.
        ASSERT_LE(passed.depth, 2 * step.blur) << step.text();
        // A tube may be so thin that rounding hides all of it: f is -e^2 in its middle.
        const bool hidden = step.exact.edge * step.exact.edge <= step.blur;
        if (tier().exact && !hidden && !step.after.refines) {
            ASSERT_LE(passed.count, 1) << step.text();
        }
    });
    EXPECT_GT(steps, trials);
    EXPECT_GT(refinements, trials / 20);
}

// What is certain, or due, is there. Of a crossing that is certain torusOccluded asks no refinement, so it is
// before the ray's end. The fast tier takes every refinement for a crossing: within r / 64, as far as a
// refinement leads, or where rounding hides a dip.
TEST_P(StageStep, ACertainCrossingExists) {
    int claims = 0;
    forSteps([&](const Step& step) {
        if (!(tier().exact ? step.after.certain : step.after.refines)) {
            return;
        }
        ++claims;
        const Long end = parameterOf(step.line, Quad(step.trial.ray.tMax));
        const bool exists = std::ranges::any_of(step.exact.roots, [&](Long root) {
            return tier().exact ? root > step.from && root <= end
                                : std::abs(root - step.after.u) <= step.exact.r / 64;
        });
        const bool hidden = !tier().exact && std::abs(step.exact.f(step.after.u)) <= 2 * step.blur;
        ASSERT_TRUE(exists || hidden) << step.text();
    });
    EXPECT_GT(claims, trials / 20);
}

INSTANTIATE_TEST_SUITE_P(Tier, StageStep, testing::Values(&exactTier(), &fastTier()), nameOfTier);

}  // namespace
}  // namespace raytorus::test
