// SPDX-License-Identifier: MIT
// The root isolation against polynomials made from known roots.
#include "reference/roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace raytorus::reference {

namespace {

// (u - a)(u - b)(u - c)(u - d)
Quartic<Quad> fromRoots(Quad a, Quad b, Quad c, Quad d) {
    const Quad s = a + b, p = a * b, t = c + d, q = c * d;
    return {p * q, -(s * q + p * t), p + q + s * t, -(s + t), 1};
}

RootList<Quad> rootsOf(const Quartic<Quad>& q, Quad low, Quad high) {
    RootList<Quad> found;
    isolate(toBernstein(q, low, high - low), low, high - low, maximumDepth<Quad>, found);
    return found;
}

void expectRoots(const RootList<Quad>& found, const std::vector<double>& expected, double tolerance) {
    ASSERT_EQ(found.count, static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(toDouble(found.roots[i].value), expected[i], tolerance) << i;
    }
}

}  // namespace

TEST(Roots, AreFoundInOrderWithTheirDirection) {
    const RootList<Quad> found = rootsOf(fromRoots(-3, 0.5, 1, 2.25), -4, 4);
    expectRoots(found, {-3, 0.5, 1, 2.25}, 0);  // exact in double, so after rounding to it
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(found.roots[i].falling, i % 2 == 0);
}

TEST(Roots, AreConfinedToTheInterval) {
    expectRoots(rootsOf(fromRoots(-3, 0.5, 1, 2.25), -2.5, 1.5), {0.5, 1}, 0);
    expectRoots(rootsOf(fromRoots(-3, 0.5, 1, 2.25), 3, 8), {}, 0);
}

// 0 is the first point of subdivision of [-4, 4]: no root there may be seen twice or not at all.
TEST(Roots, OnAPointOfSubdivisionCountOnce) {
    expectRoots(rootsOf(fromRoots(-3, 0, 1, 2), -4, 4), {-3, 0, 1, 2},
                1e-31);  // a hundred last places of the 4 to which the coefficients belong

    expectRoots(rootsOf(fromRoots(-1, 0, 0, 0), -4, 4), {-1, 0},
                1e-10);  // a triple root: a third of the bits
}

TEST(Roots, PartClusters) {
    const Quad gap = timesPowerOfTwo(Quad(1), -20);
    const Quad a = Quad(1) / 3;
    const RootList<Quad> found = rootsOf(fromRoots(a, a + gap, a + 2 * gap, a + 3 * gap), -4, 4);
    ASSERT_EQ(found.count, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        // The polynomial is 2^-80 between roots 2^-20 apart and its roundings are 2^-113 of coefficients of
        // size 4^4 on [-4, 4], times about ten: 2^-22 of the gap.
        EXPECT_NEAR(toDouble((found.roots[i].value - a) / gap), static_cast<double>(i), 1e-6);
    }
}

// Even multiplicity: a pair or nothing. Odd: one crossing, or one and a pair.
TEST(Roots, OfHigherMultiplicityKeepTheParity) {
    for (double a : {0.0, 0.3, 1.0, -1.7}) {
        EXPECT_EQ(rootsOf(fromRoots(a, a, 3, 3.5), -4, 4).count % 2, 0) << a;
        EXPECT_EQ(rootsOf(fromRoots(a, a, a, 3.5), -4, 4).count % 2, 0) << a;
        EXPECT_EQ(rootsOf(fromRoots(a, a, a, a), -4, 4).count % 2, 0) << a;
        EXPECT_EQ(rootsOf(fromRoots(a, a, a, 5), -4, 4).count % 2, 1) << a;
        EXPECT_NEAR(toDouble(rootsOf(fromRoots(a, a, a, 5), -4, 4).roots[0].value), a, 1e-10) << a;
    }
}

TEST(Roots, AreNotInvented) {
    // (u^2 + 1)(u^2 + 2) and (u^2 + 1)(u - 1)(u - 2)
    expectRoots(rootsOf({2, 0, 3, 0, 1}, -4, 4), {}, 0);
    expectRoots(rootsOf({2, -3, 3, -3, 1}, -4, 4), {1, 2}, 0);
}

TEST(Roots, DropTheClosestPairBeyondFour) {
    RootList<Quad> found;
    for (const double value : {-2.0, -1.0, 0.5, 0.5, 3.0, 4.0})
        found.add(value, found.count % 2 == 0);
    dropSpuriousPairs(found);
    expectRoots(found, {-2, -1, 3, 4}, 0);
    dropSpuriousPairs(found);
    EXPECT_EQ(found.count, 4);
}

// At a cusp the first coefficient is known by its sign alone: as small as can be, and no root is near it.
TEST(Roots, AreNotTakenForAnEndThatNearlyVanishes) {
    const Quad nearlyZero = -1e-300;
    EXPECT_NEAR(toDouble(refine<Quad>({nearlyZero, nearlyZero, -1, -1, 2})), 0.75,
                1e-15);  // 8 v^3 = 6 v^2
    const auto step = [](double x) { return x < 0.3 ? -1e-300 : 1.0; };
    EXPECT_NEAR(bracketedRoot(step, 0.0, -1e-300, 1.0, 1.0, 0x1p-49), 0.3, 0x1p-48);
}

TEST(Roots, AreRefinedToTheLastBits) {
    // u^4 - 2 has the roots +-2^(1/4); its square, squared, is 2 to within a few units in the last place.
    const RootList<Quad> found = rootsOf({-2, 0, 0, 0, 1}, 0, 4);
    ASSERT_EQ(found.count, 1);
    const Quad square = found.roots[0].value * found.roots[0].value;
    EXPECT_LE(std::abs(toDouble(square * square - 2)), std::ldexp(1.0, -108));
}

}  // namespace raytorus::reference
