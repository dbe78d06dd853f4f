// SPDX-License-Identifier: MIT
// The exact side of explanations: its numbers satisfy the equations of docs/math.md, and its roots are roots.
#include <gtest/gtest.h>

#include "explain/exact.hpp"
#include "reference/rays.hpp"
#include "support/fresh_seed.hpp"

namespace raytorus::test {
namespace {

using explain::Quad;
using explain::RootCase;
using explain::Sheet;
using explain::Steps;
using explain::TrueRoot;
using reference::Ray;
using reference::Torus;
using reference::Vec3;

// 113 bits less what evaluating a quartic far from the torus costs: origins are up to 100 R away.
constexpr double exactly = 1e-24;

// A largest float, so that it works as an end, too.
constexpr float far = 3.4e38F;

Steps<Quad> stepsOf(const Torus& torus, const Ray& ray) {
    return explain::exactSteps(torus, ray);
}

std::vector<TrueRoot> rootsOf(const Torus& torus, const Ray& ray) {
    return explain::trueRoots(torus, ray, stepsOf(torus, ray));
}

Vec3<Quad> pointAt(const Ray& ray, Quad t) {
    const Vec3<Quad> o = reference::toQuad(ray.origin), d = reference::toQuad(ray.direction);
    return {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]};
}

double magnitude(Quad x) {
    return std::abs(reference::toDouble(x));
}

// Rays of every class, about tori of every shape.
template <class Check>
void forFreshRays(Check check) {
    for (const float minor : {0.01F, 0.25F, 0.9F, 1.0F, 1.5F}) {
        for (const reference::RayClass rayClass : reference::allRayClasses) {
            reference::RayParameters parameters;
            parameters.torus = {1.0F, minor};
            parameters.distance = 10;
            parameters.seed = freshSeed();
            for (std::uint64_t i = 0; i < 12; ++i) {
                SCOPED_TRACE(reference::describeRay(rayClass, parameters, i));
                check(parameters.torus, reference::generateRay(rayClass, parameters, i).ray);
            }
        }
    }
}

TEST(ExplainExact, TheCoefficientsAreTheImplicitFunctionOnTheRay) {
    forFreshRays([](const Torus& torus, const Ray& ray) {
        const Steps<Quad> steps = stepsOf(torus, ray);
        Quad sizes = 0;
        for (const Quad unit : {Quad(-1), Quad(0), Quad(0.5), Quad(2)}) {
            const Quad t = steps.shift + steps.scale * unit;
            Quad value = 0, power = 1;
            sizes = 0;
            for (const Quad& c : steps.coefficients) {
                value += c * power;
                sizes += reference::magnitude(c * power);
                power *= t;
            }
            EXPECT_LT(magnitude(value - reference::implicit(torus, pointAt(ray, t))),
                      exactly * magnitude(sizes));
        }
    });
}

TEST(ExplainExact, TheReducedQuarticIsTheImplicitFunctionToo) {
    forFreshRays([](const Torus& torus, const Ray& ray) {
        const Steps<Quad> s = stepsOf(torus, ray);
        for (const Quad t : {Quad(-1), Quad(0), Quad(0.5), Quad(2)}) {
            const Quad value = t * t * t * t + 2 * s.alpha * t * t + 8 * s.cz * t + s.beta;
            const Quad there = reference::implicit(torus, pointAt(ray, s.shift + s.scale * t));
            EXPECT_LT(magnitude(value - there), exactly * 1e3);  // lines up to 4 R away: their fourth power
        }
        EXPECT_LT(magnitude(s.alpha - s.alphaRadial), exactly);
        EXPECT_LT(magnitude(s.cz - s.czRadial), exactly);
        EXPECT_LT(magnitude(s.beta - s.betaSum), exactly * 1e3);
    });
}

TEST(ExplainExact, YSolvesTheResolventAndSIsTheInnerRoot) {
    forFreshRays([](const Torus& torus, const Ray& ray) {
        const Steps<Quad> s = stepsOf(torus, ray);
        const Quad size = s.alpha * s.alpha + reference::magnitude(s.beta) + 1;
        EXPECT_LT(magnitude(s.y * s.y * s.y - s.delta * s.y / 3 - s.gamma / 27),
                  1e-14 * magnitude(size * size));
        const Quad m = s.S * s.S;  // (14); half the digits where it is double
        const Quad rest =
            m * m * m + 4 * s.alpha * m * m + 4 * (s.alpha * s.alpha - s.beta) * m - 64 * s.cz * s.cz;
        EXPECT_LT(magnitude(rest), 1e-14 * magnitude(size * size));
    });
}

TEST(ExplainExact, EachRootIsOneOnItsSheet) {
    forFreshRays([](const Torus& torus, const Ray& ray) {
        const double R = torus.majorRadius, r = torus.minorRadius;
        const std::vector<TrueRoot> roots = rootsOf(torus, ray);
        EXPECT_EQ(roots.size() % 2, 0U);
        for (std::size_t i = 0; i < roots.size(); ++i) {
            EXPECT_TRUE(i == 0 || roots[i - 1].t <= roots[i].t);
            const auto& p = roots[i].position;
            const Quad rho = reference::squareRoot(p[0] * p[0] + p[1] * p[1]);
            const Quad offRing = roots[i].sheet == Sheet::Outer ? rho - R : rho + R;
            // A double root has half the digits.
            EXPECT_LT(magnitude(reference::squareRoot(offRing * offRing + p[2] * p[2]) - r), 1e-13);
        }
    });
}

// On the x axis a torus is met at -R-r, r-R, R-r, R+r: whichever of them are of the outer sheet.
TEST(ExplainExact, RingAndSpindleOnTheXAxis) {
    const Ray ray{{-4.0F, 0.0F, 0.0F}, 0.0F, {1.0F, 0.0F, 0.0F}, far};
    struct Row {
        float minor;
        double at[4];
        Sheet middle;
    };
    for (const Row& row :
         {Row{0.5F, {2.5, 3.5, 4.5, 5.5}, Sheet::Outer}, Row{1.5F, {1.5, 3.5, 4.5, 6.5}, Sheet::Inner}}) {
        const std::vector<TrueRoot> roots = rootsOf({1.0F, row.minor}, ray);
        ASSERT_EQ(roots.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(reference::toDouble(roots[i].t), row.at[i], 1e-15);
            EXPECT_EQ(roots[i].sheet, i == 0 || i == 3 ? Sheet::Outer : row.middle)
                << row.minor << ", root " << i;
        }
    }
}

// (t^2 - 1/4) (t^2 - 9/4) by hand.
TEST(ExplainExact, NumbersOfARayThroughTheCentre) {
    const Steps<Quad> s = stepsOf({2.0F, 1.0F}, {{-6.0F, 0.0F, 0.0F}, 0.0F, {2.0F, 0.0F, 0.0F}, far});
    EXPECT_TRUE(s.tubeRadius == 0.5 && s.shift == 3 && s.scale == 1);
    EXPECT_TRUE(s.alpha == -1.25 && s.cz == 0 && s.beta == 0.5625);
    EXPECT_TRUE(s.direction[0] == 1 && s.origin[0] == 0);
    EXPECT_TRUE(s.coefficients[0] == 16 * 59.0625 && s.coefficients[4] == 16);
    EXPECT_EQ(s.rootCase, RootCase::Biquadratic);
}

// The axis of a horn: a fourfold root, of which the reference says two are hits and the inner sheet has the
// others.
TEST(ExplainExact, TheTipOfAHornIsFourfold) {
    const std::vector<TrueRoot> roots =
        rootsOf({1.0F, 1.0F}, {{0.0F, 0.0F, 2.0F}, 0.0F, {0.0F, 0.0F, -1.0F}, far});
    ASSERT_EQ(roots.size(), 4U);
    for (const TrueRoot& root : roots) {
        EXPECT_NEAR(reference::toDouble(root.t), 2.0, 1e-8);
    }
}

TEST(ExplainExact, Cases) {
    const Torus ring{1.0F, 0.25F};
    struct Row {
        Ray ray;
        RootCase rootCase;
        std::size_t roots;
    };
    for (const Row& row :
         {Row{{{-3.0F, 0.3F, 0.1F}, 0.0F, {1.0F, 0.1F, -0.02F}, far}, RootCase::FourOrNone, 4},
          Row{{{-3.0F, 0.2F, 0.4F}, 0.0F, {1.0F, 0.1F, 0.02F}, far}, RootCase::FourOrNone, 0},
          Row{{{-3.0F, 0.3F, 0.1F}, 0.0F, {1.0F, 0.1F, 0.05F}, far}, RootCase::Two, 2},
          Row{{{1.0F, 0.0F, 3.0F}, 0.0F, {0.0F, 0.0F, -1.0F}, far}, RootCase::Biquadratic, 2}}) {
        EXPECT_EQ(stepsOf(ring, row.ray).rootCase, row.rootCase);
        EXPECT_EQ(rootsOf(ring, row.ray).size(), row.roots);
    }
    EXPECT_EQ(stepsOf({0.0F, 1.0F}, {{1.0F, 0.0F, 3.0F}, 0.0F, {0.0F, 0.0F, -1.0F}, far}).rootCase,
              RootCase::None);
    // R + 0.6 r, 0.8 r is a point of the tube; from it along both tangents.
    const Steps<Quad> tangent =
        stepsOf({2.0F, 0.625F}, {{2.375F, 0.0F, 0.5F}, 0.0F, {-4.0F, 4.0F, 3.0F}, far});
    EXPECT_TRUE(tangent.cz != 0);
    EXPECT_EQ(tangent.rootCase, RootCase::Multiple);
    // One ulp aside there is no double root.
    EXPECT_NE(stepsOf({2.0F, 0.625F}, {{2.3750002F, 0.0F, 0.5F}, 0.0F, {-4.0F, 4.0F, 3.0F}, far}).rootCase,
              RootCase::Multiple);
}

}  // namespace
}  // namespace raytorus::test
