// SPDX-License-Identifier: MIT
// The closed form in 113 bits, where rounding is out of the way: its formulas have the roots of every ray,
// and of every special case by its name. The roots are held to Descartes' method, or to numbers found by
// hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "closed_form_cxx.hpp"
#include "closed_form_reference.hpp"
#include "reference/rays.hpp"
#include "support/fresh_seed.hpp"

namespace raytorus {
namespace {

using reference::Quad;
using reference::RayClass;
using test::Triple;
using Cxx = test::ClosedFormCxx<Quad>;
using Quartic = test::ReducedQuartic<Quad>;
using Roots = test::QuarticRoots<Quad>;

// 113 bits are right to 1e-34. A double root keeps half of these digits, 1e-17, as does an inner root that
// vanishes. The axis of a horn meets its tip in a quadruple root, which keeps a quarter: 3e-9. Times 30 to 60
// for what a few dozen roundings and w, alpha and beta up to 6 add.
constexpr double ordinary = 1e-15;
constexpr double atTheTip = 1e-7;

std::vector<Quad> list(const Roots& roots) {
    return {roots.roots.begin(), roots.roots.begin() + roots.count};
}

class ClosedForm : public testing::TestWithParam<RayClass> {};

TEST_P(ClosedForm, HasTheRootsOfRandomRaysInBothVersions) {
    constexpr std::uint64_t raysEach = 300;
    double worst[2] = {0, 0};
    std::vector<double> errors;
    std::size_t roots = 0;
    for (const float minorRadius : {0.01F, 0.1F, 0.5F, 0.9F, 1.0F, 1.5F}) {
        for (const double distance : {3.0, 1000.0}) {
            const reference::RayParameters parameters{{1.0F, minorRadius}, distance, 1e-4, test::freshSeed()};
            for (std::uint64_t i = 0; i < raysEach; ++i) {
                const reference::Ray ray = generateRay(GetParam(), parameters, i).ray;
                const Triple<Quad> origin = test::quads(ray.origin);
                const Triple<Quad> direction = test::quads(ray.direction);
                const std::vector<Quad> truth = test::allRoots(parameters.torus, origin, direction);
                roots += truth.size();
                Cxx::Ray reduced;
                if (!Cxx::reduceRay(1, minorRadius, origin, direction, reduced)) {
                    ASSERT_TRUE(truth.empty()) << describeRay(GetParam(), parameters, i);
                    continue;
                }
                const Roots versions[] = {Cxx::reducedRoots(Cxx::axialQuartic(reduced)),
                                          Cxx::reducedRootsUnhalved(Cxx::radialQuartic(reduced)),
                                          Cxx::closedFormRoots(1, minorRadius, origin, direction)};
                for (int v = 0; v < 3; ++v) {
                    std::vector<Quad> found = list(versions[v]);
                    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
                    if (v < 2) {
                        for (Quad& t : found) {
                            t = reduced.shift + reduced.scale * t;
                        }
                    }
                    const test::RootsDifference off = test::difference(truth, found, reduced.scale);
                    const bool tip = minorRadius >= 1.0F;
                    worst[tip] = std::max({worst[tip], off.pairs, off.values});
                    errors.push_back(off.values);
                    ASSERT_LE(std::max(off.pairs, off.values), tip ? atTheTip : ordinary)
                        << "version " << v + 1 << ": " << describeRay(GetParam(), parameters, i);
                }
            }
        }
    }
    fmt::print("{}: {} roots, off by {:.1e} R at most, {:.1e} R of horns and spindles\n", nameOf(GetParam()),
               roots, worst[0], worst[1]);
    EXPECT_GT(roots, raysEach);
    // Half of the rays are nowhere near a special case: they keep nearly all of the 113 bits. Seen: up to
    // 7e-32.
    std::nth_element(errors.begin(), errors.begin() + std::ssize(errors) / 2, errors.end());
    EXPECT_LE(errors[errors.size() / 2], 1e-28);
}

INSTANTIATE_TEST_SUITE_P(Classes, ClosedForm, testing::ValuesIn(reference::allRayClasses),
                         [](const auto& row) { return std::string(nameOf(row.param)); });

// The second version as the derivation this project started from prints it, zeta = cbrt(gamma) +
// sqrt(epsilon), has the roots of no ray; the sum under the cube root, as in the library, solves the
// resolvent cubic of each.
TEST(ClosedFormErrata, TheSumStandsUnderTheCubeRoot) {
    const Quad two = cbrtq(Quad(2));
    int rays = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        // The same rays always: a shown example, not a search.
        const reference::Ray ray = generateRay(RayClass::camera, {{1, 0.5F}, 3.0, 0, 23}, i).ray;
        Cxx::Ray reduced;
        if (!Cxx::reduceRay(1, 0.5, test::quads(ray.origin), test::quads(ray.direction), reduced)) {
            continue;
        }
        const Quartic f = Cxx::radialQuartic(reduced);
        const Quad gamma = 16 * f.alpha * f.alpha * f.alpha - 144 * f.alpha * f.beta + 1728 * f.cz * f.cz;
        const Quad delta = 4 * f.alpha * f.alpha + 12 * f.beta;
        const Quad epsilon = gamma * gamma - 4 * delta * delta * delta;
        if (epsilon < 0) {
            continue;
        }
        ++rays;
        // What is left of y^3 - delta y / 3 - gamma / 27, in its own terms.
        const auto residual = [&](Quad zeta) {
            const Quad y = zeta / (3 * two) + two * delta / (3 * zeta);
            const Quad terms[] = {y * y * y, delta * y / 3, gamma / 27};
            return static_cast<double>(fabsq(terms[0] - terms[1] - terms[2]) /
                                       (fabsq(terms[0]) + fabsq(terms[1]) + fabsq(terms[2])));
        };
        const Quad sum = gamma < 0 ? gamma - sqrtq(epsilon) : gamma + sqrtq(epsilon);
        EXPECT_LE(residual(cbrtq(sum)), 1e-30);  // 113 bits: 1e-34 a rounding
        EXPECT_GE(residual(cbrtq(gamma) + sqrtq(epsilon)), 1e-6);
    }
    EXPECT_GT(rays, 200);
}

// Each special case by its name. Numbers that are known by hand are exact.

Quartic quarticOf(float minorRadius, const Triple<Quad>& origin, const Triple<Quad>& direction) {
    Cxx::Ray reduced;
    EXPECT_TRUE(Cxx::reduceRay(1, minorRadius, origin, direction, reduced));
    return Cxx::axialQuartic(reduced);
}

Quad epsilonOf(const Quartic& f) {
    const Quad gamma = 16 * f.alpha * f.alpha * f.alpha - 144 * f.alpha * f.beta + 1728 * f.cz * f.cz;
    const Quad delta = 4 * f.alpha * f.alpha + 12 * f.beta;
    return gamma * gamma - 4 * delta * delta * delta;
}

void expectRoots(const Quartic& quartic, const std::vector<Quad>& expected, double tolerance = ordinary) {
    for (const Roots& roots : {Cxx::reducedRoots(quartic), Cxx::reducedRootsUnhalved(quartic)}) {
        const test::RootsDifference off = test::difference(expected, list(roots), Quad(1));
        EXPECT_EQ(static_cast<std::size_t>(roots.count), expected.size());
        EXPECT_LE(std::max(off.pairs, off.values), tolerance);
    }
}

/// t^4 + 2 alpha t^2 + 8 cz t + beta from roots whose sum is 0.
Quartic withRoots(Quad a, Quad b, Quad c) {
    const Quad d = -(a + b + c);
    return {(a * b + (a + b) * (c + d) + c * d) / 2, -(a * b * (c + d) + (a + b) * c * d) / 8, a * b * c * d};
}

TEST(ClosedFormCase, EpsilonNegativeWithFourRoots) {
    const Quartic f = quarticOf(0.5F, {-3, Quad(0.125F), Quad(0.0625F)}, {1, Quad(0.0625F), Quad(0.03125F)});
    EXPECT_LT(epsilonOf(f), 0);
    EXPECT_NE(f.cz, 0);
    EXPECT_EQ(Cxx::reducedRoots(f).count, 4);
    // 1e-34 a rounding: the third of the angle is iterated as far as that.
    expectRoots(withRoots(-3, -1, Quad(0.5F)), {-3, -1, 0.5, 3.5}, 1e-31);
}

// Down the hole, not quite along the axis: four complex roots.
TEST(ClosedFormCase, EpsilonNegativeWithNone) {
    const Quartic f = quarticOf(0.25F, {Quad(0.125F), 0, 0.5}, {Quad(0.0625F), Quad(0.125F), 1});
    EXPECT_LT(epsilonOf(f), 0);
    EXPECT_NE(f.cz, 0);
    expectRoots(f, {});
    // (t^2 + 2 t + 3)(t^2 - 2 t + 5)
    expectRoots({2, Quad(0.5F), 15}, {});
}

TEST(ClosedFormCase, EpsilonPositiveWithTwoRoots) {
    // (t^2 + 2 t + 3)(t^2 - 2 t - 3)
    const Quartic f{-2, Quad(-1.5F), -9};
    EXPECT_GT(epsilonOf(f), 0);
    expectRoots(f, {-1, 3});
}

// gamma = delta = 0: (t - 1)^3 (t + 3), and the same mirrored.
TEST(ClosedFormCase, ZetaZeroIsATripleRoot) {
    for (const int side : {1, -1}) {
        const Quartic f{-3, Quad(side), -3};
        EXPECT_EQ(epsilonOf(f), 0);
        const Quad s = side;
        expectRoots(f, side > 0 ? std::vector<Quad>{-3, s, s, s} : std::vector<Quad>{s, s, s, 3});
    }
}

// delta = 0 and gamma < 0: gamma + sqrt(epsilon) is 0, but y is not. Held to the polynomial itself, whose
// slope at its roots is above 4 and whose terms are below 60.
TEST(ClosedFormCase, DeltaZeroWithNegativeGamma) {
    const Quartic f{-3, Quad(0.5F), -3};
    for (const Roots& roots : {Cxx::reducedRoots(f), Cxx::reducedRootsUnhalved(f)}) {
        ASSERT_EQ(roots.count, 2);
        for (const Quad t : list(roots)) {
            EXPECT_LE(std::abs(static_cast<double>(((t * t - 6) * t + 4) * t - 3)), 1e-30);
        }
    }
}

// c z = 0: a line in the plane z = 0, whose roots are those of two circles.
TEST(ClosedFormCase, BiquadraticWithFourRoots) {
    const Quartic f = quarticOf(0.25F, {-5, 0, 0}, {2, 0, 0});
    EXPECT_EQ(f.cz, 0);
    expectRoots(f, {-1.25, -0.75, 0.75, 1.25});
}

TEST(ClosedFormCase, BiquadraticWithTwoRoots) {
    const Quartic f = quarticOf(0.25F, {-5, 1, 0}, {1, 0, 0});
    EXPECT_EQ(f.cz, 0);
    expectRoots(f, {-0.75, 0.75});
}

TEST(ClosedFormCase, BiquadraticWithNoRoots) {
    // At 1.25 above the ring's plane nothing is met, though the bounding sphere of w = 1/2 is.
    expectRoots(quarticOf(0.5F, {-5, 0, 1.25}, {1, 0, 0}), {});
    // alpha > 0, beta > 0: both squares are negative.
    expectRoots({2, 0, 3}, {});
    // alpha^2 < beta: both are complex.
    expectRoots({-1, 0, 2}, {});
}

TEST(ClosedFormCase, BiquadraticOfNothingButT) {
    expectRoots({0, 0, 0}, {0, 0, 0, 0});
    expectRoots({-2, 0, 0}, {-2, 0, 0, 2});
    expectRoots({2, 0, 0}, {0, 0});
}

TEST(ClosedFormCase, TangentsAreDoubleRoots) {
    // The outer equator, the inner one (met again at sqrt(1.25^2 - 0.75^2) = 1), and the top circle, twice.
    expectRoots(quarticOf(0.25F, {1.25, -5, 0}, {0, 1, 0}), {0, 0});
    expectRoots(quarticOf(0.25F, {0.75, -5, 0}, {0, 1, 0}), {-1, 0, 0, 1});
    expectRoots(quarticOf(0.25F, {0, -5, 0.25}, {0, 1, 0}), {-1, -1, 1, 1});
    // With c z not 0: the upper pair, the lower one.
    expectRoots(withRoots(1, 1, Quad(0.5F)), {-2.5, 0.5, 1, 1});
    expectRoots(withRoots(-1, -1, Quad(0.5F)), {-1, -1, 0.5, 1.5});
}

// The bitangent line through the centre, sin = r / R = 3/5: it touches at t = -+ 4 / 5 of R.
TEST(ClosedFormCase, TheBitangentLineOfVillarceausPlaneIsTwoDoubleRoots) {
    Cxx::Ray reduced;
    ASSERT_TRUE(Cxx::reduceRay(5, 3, {-16, 0, -12}, {4, 0, 3}, reduced));
    expectRoots(Cxx::axialQuartic(reduced), {-0.8, -0.8, 0.8, 0.8}, 1e-15);
}

TEST(ClosedFormCase, ParallelToTheAxis) {
    expectRoots(quarticOf(0.25F, {1, 0, 5}, {0, 0, -3}), {-0.25, 0.25});
    expectRoots(quarticOf(1.25F, {Quad(0.25F), 0, 5}, {0, 0, 1}), {-1, 0, 0, 1});
}

// r = 5/4, R = 3/4: along x the outer sheet is met at -+2, the inner one at -+1/2; along the axis both at the
// tips.
TEST(ClosedFormCase, BothSheetsOfASpindleAreRoots) {
    const Roots along = Cxx::closedFormRoots(0.75, 1.25, {5, 0, 0}, {-1, 0, 0});
    EXPECT_LE(test::difference({3, 4.5, 5.5, 7}, list(along), 1).values, ordinary);
    EXPECT_EQ(along.count, 4);
    const Roots axis = Cxx::closedFormRoots(0.75, 1.25, {0, 0, 5}, {0, 0, -1});
    EXPECT_LE(test::difference({4, 4, 6, 6}, list(axis), 1).values, ordinary);
    EXPECT_EQ(axis.count, 4);
}

TEST(ClosedFormCase, TOfTheRayAsGivenFromAnywhere) {
    const Roots far = Cxx::closedFormRoots(2, 0.5, {-1e6, 0, 0}, {Quad(0.5F), 0, 0});
    EXPECT_EQ(far.count, 4);
    EXPECT_LE(test::difference({2e6 - 5, 2e6 - 3, 2e6 + 3, 2e6 + 5}, list(far), 1).values, ordinary);
}

}  // namespace
}  // namespace raytorus
