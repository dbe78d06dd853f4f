// SPDX-License-Identifier: MIT
// The reference intersection against facts that need no computer: chords, tangents, planes of symmetry, and
// against hard rays that other projects have published.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/torus_reference.hpp"
#include "support/special_floats.hpp"

namespace raytorus::reference {

namespace {

const Quad quadInfinity{infinity};

// Distances of about 10 have a last place of 2^-109 = 1.5e-33; a simple root may lose a few hundred of them.
const double simpleRootError = 1e-30;
// A double root is known to half the bits: 2^-56 of the size of the torus.
const double doubleRootError = 1e-15;
// Extrema of the distance are bracketed to 2^-49; where a line meets the ring itself the distance has an
// edge.
const double extremumError = 1e-14;

void expectHits(const Intersections& found, const std::vector<Quad>& expected, double tolerance) {
    ASSERT_EQ(found.count, static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LE(std::abs(toDouble(found.hits[i].t - expected[i])), tolerance)
            << "hit " << i << " at " << toDouble(found.hits[i].t) << ", not " << toDouble(expected[i]);
    }
}

// A tangent point counts twice or not at all.
void expectTangent(const Intersections& found, const std::vector<Quad>& simple, Quad tangent) {
    std::vector<Quad> both = simple;
    both.insert(both.begin() + static_cast<std::ptrdiff_t>(simple.size() / 2), 2, tangent);
    EXPECT_LE(found.clearance, 1e-30);
    expectHits(found, found.count == static_cast<int>(simple.size()) ? simple : both, doubleRootError);
}

Intersections intersectFloat(const Torus& torus, const Ray& ray) {
    return intersect(torus, ray);
}

}  // namespace

TEST(Reference, MeetsTheTubeTwiceThroughTheCentreAlongX) {
    const Intersections found = intersectFloat({1, 0.25f}, {{-5, 0, 0}, 0, {1, 0, 0}, infinity});
    expectHits(found, {3.75, 4.25, 5.75, 6.25}, simpleRootError);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(found.hits[i].entering, i % 2 == 0);
    EXPECT_NEAR(found.clearance, 1,
                extremumError);  // the ring itself and the centre, which is 3 r from the tube
    EXPECT_EQ(found.startClearance, 15);
    EXPECT_TRUE(std::isinf(found.stopClearance));
    EXPECT_FALSE(found.startsInside);
    EXPECT_EQ(toDouble(found.hits[0].position), (std::array{-1.25, 0.0, 0.0}));
}

TEST(Reference, MeetsTheTubeAtItsFullHeightAlongTheAxis) {
    expectHits(intersectFloat({1, 0.25f}, {{0, -1, 5}, 0, {0, 0, -2}, infinity}), {2.375, 2.625},
               simpleRootError);
    expectHits(intersectFloat({1, 0.25f}, {{0, 0, 5}, 0, {0, 0, -1}, infinity}), {}, 0);
}

TEST(Reference, CountsOddFromInside) {
    const Intersections found = intersectFloat({1, 0.25f}, {{1, 0, 0}, 0, {-1, 0, 0}, infinity});
    expectHits(found, {0.25, 1.75, 2.25}, simpleRootError);
    EXPECT_TRUE(found.startsInside);
    EXPECT_FALSE(found.hits[0].entering);
}

TEST(Reference, KeepsToTheInterval) {
    const Torus torus{1, 0.25f};
    expectHits(intersectFloat(torus, {{-5, 0, 0}, 4, {1, 0, 0}, 6}), {4.25, 5.75}, simpleRootError);
    expectHits(intersectFloat(torus, {{-5, 0, 0}, -100, {1, 0, 0}, 3.5f}), {}, 0);
    expectHits(intersectFloat(torus, {{5, 0, 0}, -infinity, {1, 0, 0}, 0}), {-6.25, -5.75, -4.25, -3.75},
               simpleRootError);
    const Intersections nearEnd = intersectFloat(torus, {{-5, 0, 0}, 4, {1, 0, 0}, 6.25f + 0.0009765625f});
    EXPECT_EQ(nearEnd.count, 3);
    EXPECT_TRUE(nearEnd.startsInside);
    EXPECT_EQ(nearEnd.startClearance, 1);
    EXPECT_EQ(nearEnd.stopClearance, 0.00390625);
    EXPECT_EQ(nearEnd.endClearance(), 0.00390625);
}

TEST(Reference, TouchesTheEquatorsAndTheTopCircle) {
    const Torus torus{1, 0.25f};
    expectTangent(intersectFloat(torus, {{1.25f, -5, 0}, 0, {0, 1, 0}, infinity}), {}, 5);
    // sqrt(1.25^2 - 0.75^2) = 1
    expectTangent(intersectFloat(torus, {{0.75f, -5, 0}, 0, {0, 1, 0}, infinity}), {4, 6}, 5);
    // Across the top circle at rho = 1 the line z = r touches the tube from outside, twice.
    const Intersections top = intersectFloat(torus, {{0, -5, 0.25f}, 0, {0, 1, 0}, infinity});
    EXPECT_EQ(top.clearance, 0);
    EXPECT_EQ(top.count % 2, 0);
}

// Moving the tangent by one float step decides.
// Where the touching point is a point of subdivision, the sign of the polynomial there is rounding alone.
TEST(Reference, KeepsTheCrossingsBesideATouchingPoint) {
    for (int k = 1; k < 64; ++k) {
        const float minorRadius = static_cast<float>(k) / 64;
        const Quad outer = squareRoot((1 + Quad(minorRadius)) * (1 + Quad(minorRadius)) -
                                      (1 - Quad(minorRadius)) * (1 - Quad(minorRadius)));
        expectTangent(intersectFloat({1, minorRadius}, {{1 - minorRadius, -5, 0}, 0, {0, 1, 0}, infinity}),
                      {5 - outer, 5 + outer}, 5);
    }
}

TEST(Reference, DecidesBesideATangent) {
    const Torus torus{1, 0.25f};
    const auto hitsAt = [&](float x) { return intersectFloat(torus, {{x, -5, 0}, 0, {0, 1, 0}, infinity}); };
    EXPECT_EQ(hitsAt(std::nextafter(1.25f, 0.0f)).count, 2);
    EXPECT_EQ(hitsAt(std::nextafter(1.25f, 2.0f)).count, 0);
    EXPECT_EQ(hitsAt(std::nextafter(0.75f, 0.0f)).count, 4);
    EXPECT_EQ(hitsAt(std::nextafter(0.75f, 1.0f)).count, 2);
    const double floatStep = std::ldexp(1.0, -23) / 0.25;  // in units of minorRadius
    EXPECT_NEAR(hitsAt(std::nextafter(1.25f, 2.0f)).clearance, floatStep, 1e-9 * floatStep);
}

// The bitangent plane z = x tan(a), sin(a) = r/R, cuts the torus in two circles of radius R with centres at
// y = +-r. With R = 5, r = 3 the plane holds the direction (4, 0, 3) and all is representable.
TEST(Reference, MeetsVillarceauCircles) {
    const Torus torus{5, 3};
    const Quad slant = Quad(4) / 5, rise = Quad(3) / 5;
    for (double s : {-4.0, -2.5, -1.0, 0.5, 3.0}) {
        // Along y at distance s from the centre: the chords of both circles, |y -+ r| = sqrt(R^2 - s^2).
        const PreciseRay ray({Quad(s) * slant, -20, Quad(s) * rise}, 0, {0, 1, 0}, quadInfinity);
        const Quad half = squareRoot(Quad(25) - Quad(s) * Quad(s));
        std::vector<Quad> expected{20 - 3 - half, 20 + 3 - half, 20 - 3 + half, 20 + 3 + half};
        if (expected[2] < expected[1]) std::swap(expected[1], expected[2]);
        expectHits(intersect(torus, ray), expected, simpleRootError);
    }
    // Through the centre along (4, 0, 3) the line touches the tube at both points where the circles cross.
    const Intersections touching = intersectFloat(torus, {{-16, 0, -12}, 0, {4, 0, 3}, infinity});
    EXPECT_LE(touching.clearance, 1e-15);  // the extremum's place is known to a double's precision
    EXPECT_EQ(touching.count % 2, 0);
}

// Far origins and extreme exponents cost nothing: all numbers here are exact.
TEST(Reference, KnowsNoDistanceAndNoUnit) {
    const Torus torus{1, 0.25f};
    const float far = std::ldexp(1.0f, 40);
    const Quad D(far);
    expectHits(intersectFloat(torus, {{-far, 0, 0}, 0, {1, 0, 0}, infinity}),
               {D - 1.25, D - 0.75, D + 0.75, D + 1.25},
               simpleRootError * 1e12);  // 1e12 is D: t's last place
    const Intersections oblique = intersectFloat(torus, {{-3 * far, -4 * far, 0}, 0, {3, 4, 0}, infinity});
    ASSERT_EQ(oblique.count, 4);
    EXPECT_LE(std::abs(toDouble(oblique.hits[0].position[0] + Quad(3) / 4)), simpleRootError);
    EXPECT_LE(std::abs(toDouble(oblique.hits[0].position[1] + 1)), simpleRootError);

    const float tiny = std::ldexp(1.0f, -100), subnormal = std::ldexp(1.0f, -140);
    const Intersections small =
        intersectFloat({tiny, tiny / 4}, {{-5 * tiny, 0, 0}, 0, {subnormal, 0, 0}, infinity});
    const Quad unit = timesPowerOfTwo(Quad(1), 40);
    expectHits(small, {3.75 * unit, 4.25 * unit, 5.75 * unit, 6.25 * unit}, simpleRootError * 1e12);
    EXPECT_NEAR(small.clearance, 1, extremumError);
}

// One line from two origins, 2^70 apart: all of both are exact in 113 bits, so the shift to the torus must be
// too.
TEST(Reference, PutsALineAtOnePlaceWhereverItStarts) {
    const Torus torus{1, 0.25f};
    const QuadVec3 direction{Quad(0.8f), Quad(0.1f), Quad(-0.07f)}, origin{-3, Quad(-0.3f), Quad(0.2f)};
    const Quad way = timesPowerOfTwo(Quad(1), 70) + 12345;  // more bits than one step of a double takes
    const QuadVec3 far{origin[0] - way * direction[0], origin[1] - way * direction[1],
                       origin[2] - way * direction[2]};
    const Intersections here = intersect(torus, PreciseRay(origin, 0, direction, quadInfinity));
    const Intersections there = intersect(torus, PreciseRay(far, 0, direction, quadInfinity));
    ASSERT_EQ(here.count, 4);
    ASSERT_EQ(there.count, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(std::abs(toDouble(there.hits[i].position[k] - here.hits[i].position[k])),
                      simpleRootError);
        }
    }
}

TEST(Reference, IsASphereForNoMajorRadius) {
    expectHits(intersectFloat({0, 1.25f}, {{1, 0, 5}, 0, {0, 0, -1}, infinity}), {4.25, 5.75},
               simpleRootError);
    expectTangent(intersectFloat({0, 1.25f}, {{1, 0.75f, 0}, -1, {3, -4, 0}, infinity}), {}, 0);
    expectHits(intersectFloat({0, 1.25f}, {{1.5f, 0, 5}, 0, {0, 0, -1}, infinity}), {}, 0);
    const Intersections tangent = intersectFloat({0, 1.25f}, {{1.25f, 0, 5}, 0, {0, 0, -1}, infinity});
    expectTangent(tangent, {}, 5);
    // Nearly a sphere: the tube's centre circle is 2^-40 wide, so along the axis the sphere is met at
    // sqrt(r^2 - R^2), along x at R + r.
    const Quad R = timesPowerOfTwo(Quad(1), -40);
    expectHits(intersect({R, 1}, PreciseRay({-5, 0, 0}, 0, {1, 0, 0}, quadInfinity)), {4 - R, 6 + R}, 1e-20);
}

// r = 5/4, R = 3/4: the cusps lie at z = +-1.
TEST(Reference, SeesOnlyTheOuterSheetOfASpindle) {
    const Torus torus{0.75f, 1.25f};
    expectHits(intersectFloat(torus, {{5, 0, 0}, 0, {-1, 0, 0}, infinity}), {3, 7}, simpleRootError);
    expectHits(intersectFloat(torus, {{0.25f, 0, 0}, 0, {1, 0, 0}, infinity}), {1.75}, simpleRootError);
    // Along the axis both sheets are met at the cusps: double roots of the quartic, but one hit each.
    const Intersections axis = intersectFloat(torus, {{0, 0, 5}, 0, {0, 0, -1}, infinity});
    expectHits(axis, {4, 6}, doubleRootError);
    EXPECT_TRUE(axis.hits[0].entering);
    EXPECT_FALSE(axis.hits[1].entering);
    // Steeply through a cusp from the dimple: one crossing there. Level through it: touched from inside.
    expectHits(intersectFloat(torus, {{4, 0, 5}, 0, {-1, 0, -1}, infinity}), {4, 5.75}, doubleRootError);
    expectTangent(intersectFloat(torus, {{5, 0, 1}, 0, {-1, 0, 0}, infinity}), {3.5, 6.5}, 5);
    // Across the dimple at z = 9/8: (rho - 3/4)^2 = 25/16 - 81/64 = 19/64
    const Quad wide = squareRoot(Quad(19)) / 8;
    expectHits(intersectFloat(torus, {{5, 0, 1.125f}, 0, {-1, 0, 0}, infinity}),
               {5 - 0.75 - wide, 5 - 0.75 + wide, 5 + 0.75 - wide, 5 + 0.75 + wide}, simpleRootError);
}

TEST(Reference, TouchesAHornAtTheCentre) {
    const Torus torus{1, 1};
    expectTangent(intersectFloat(torus, {{5, 0, 0}, 0, {-1, 0, 0}, infinity}), {3, 7}, 5);
    expectTangent(intersectFloat(torus, {{3, 0, 3}, 0, {-1, 0, -1}, infinity}), {2, 4}, 3);
    expectTangent(intersectFloat(torus, {{0, 0, 5}, 0, {0, 0, -1}, infinity}), {}, 5);
}

// Celeritas, a spindle-free torus hit from inside; the numbers are decimal and the direction is normalised.
TEST(Reference, AgreesWithCeleritas) {
    QuadVec3 direction{Quad(0.852793), Quad(-0.522249), Quad(-0.000020)};
    const Quad length = squareRoot(dot(direction, direction));
    for (Quad& component : direction)
        component = component / length;
    const PreciseRay ray({Quad(160.371250), Quad(-6.351337), Quad(-0.000241)}, 0, direction, quadInfinity);
    // published to 18 digits by a double-precision solver: an error of a few 2^-53 of 100 is theirs
    expectHits(intersect({143, Quad(113.2)}, ray), {Quad(103.849236905981768)}, 1e-13);
}

// VecGeom, a thin ring seen along the tube: the second root is 3 orders of magnitude nearer than the others.
TEST(Reference, AgreesWithVecGeom) {
    QuadVec3 direction{Quad(-0.646752), Quad(-0.762700), Quad(-0.000012)};
    const Quad length = squareRoot(dot(direction, direction));
    for (Quad& component : direction)
        component = component / length;
    const PreciseRay ray({Quad(1230.993171), Quad(1078.075896), Quad(-2.947036)}, -quadInfinity, direction,
                         quadInfinity);
    const Intersections found = intersect({1640, 6}, ray);
    expectHits(
        found,
        {Quad(-8.9896), Quad(1.57856004146444523), Quad(3235.2362263361181), Quad(3245.75958394709075)},
        5e-5);  // the first is published to four decimals
    // the others were computed in double from numbers of 1e3: 2^-53 * 1e3, and some cancellation at the
    // second
    EXPECT_NEAR(toDouble(found.hits[1].t), 1.57856004146444523, 5e-13);
    EXPECT_NEAR(toDouble(found.hits[2].t), 3235.2362263361181, 2e-12);
    EXPECT_NEAR(toDouble(found.hits[3].t), 3245.75958394709075, 2e-12);
}

TEST(Reference, MissesForInvalidInput) {
    const Torus torus{1, 0.25f};
    const Ray ray{{-5, 0, 0}, 0, {1, 0, 0}, infinity};
    ASSERT_EQ(intersectFloat(torus, ray).count, 4);
    for (const Torus& invalid :
         {Torus{1, 0}, Torus{1, -0.25f}, Torus{-1, 0.25f}, Torus{-0.125f, 0.25f}, Torus{nan, 0.25f},
          Torus{1, nan}, Torus{infinity, 0.25f}, Torus{1, infinity}}) {
        const Intersections none = intersectFloat(invalid, ray);
        EXPECT_EQ(none.count, 0) << invalid.majorRadius << ' ' << invalid.minorRadius;
        EXPECT_TRUE(std::isinf(none.clearance)) << invalid.majorRadius << ' ' << invalid.minorRadius;
    }
    for (float bad : {nan, infinity, -infinity}) {
        for (int i = 0; i < 3; ++i) {
            Ray from = ray, along = ray;
            from.origin[i] = bad;
            along.direction[i] = bad;
            EXPECT_EQ(intersectFloat(torus, from).count, 0) << bad << i;
            EXPECT_EQ(intersectFloat(torus, along).count, 0) << bad << i;
        }
    }
    EXPECT_EQ(intersectFloat(torus, {{-5, 0, 0}, 0, {0, -0.0f, 0}, infinity}).count, 0);
    EXPECT_EQ(intersectFloat(torus, {{-5, 0, 0}, 7, {1, 0, 0}, 6}).count, 0);
    EXPECT_EQ(intersectFloat(torus, {{-5, 0, 0}, nan, {1, 0, 0}, infinity}).count, 0);
    EXPECT_EQ(intersectFloat(torus, {{-5, 0, 0}, 0, {1, 0, 0}, nan}).count, 0);
    EXPECT_TRUE(std::isinf(intersectFloat(torus, {{-5, 0, 0}, 0, {1, 0, 0}, nan}).clearance));
}

}  // namespace raytorus::reference
