// SPDX-License-Identifier: MIT
// The reference surface functions against the one equation of the parametrisation and against brute force.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/random.hpp"
#include "reference/torus_reference.hpp"

namespace raytorus::reference {

namespace {

const Torus someOfEachSort[] = {{1, 1e-4f}, {1, 0.25f}, {1, 1}, {0.75f, 1.25f}, {0, 1}};

QuadVec3 quad(const DoubleVec3& v) {
    return {v[0], v[1], v[2]};
}

QuadVec3 sum(const QuadVec3& a, Quad s, const QuadVec3& b) {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

double gap(const QuadVec3& a, const QuadVec3& b) {
    const QuadVec3 d = sum(a, -1, b);
    return toDouble(squareRoot(dot(d, d)));
}

// u, v of the outer sheet, away from the axis, where u is lost
QuadVec2 randomUv(Random& random, const Torus& torus) {
    for (;;) {
        const QuadVec2 uv{random.uniform(), random.uniform()};
        if (double{torus.majorRadius} + double{torus.minorRadius} * std::cos(2 * M_PI * toDouble(uv[1])) >
            1e-3)
            return uv;
    }
}

// Points in and around the torus, never nearer to the axis than 1e-3.
QuadVec3 randomPoint(Random& random, const Torus& torus) {
    for (;;) {
        const QuadVec3 p =
            quad((double{torus.majorRadius} + 2 * double{torus.minorRadius}) * random.inBall());
        if (p[0] * p[0] + p[1] * p[1] > 1e-6) return p;
    }
}

// Distance to the profile sampled as points; the profile is the arc of the circle with rho >= 0.
double sampledDistance(const Torus& torus, double rho, double z) {
    const int samples = 20000;
    const double R{torus.majorRadius}, r{torus.minorRadius};
    double nearest = 1e30;
    for (int i = 0; i < samples; ++i) {
        const double v = 2 * M_PI * i / samples;
        const double profileRho = R + r * std::cos(v);
        if (profileRho < 0) continue;
        nearest = std::min(nearest, std::hypot(rho - profileRho, z - r * std::sin(v)));
    }
    return nearest;
}

}  // namespace

// The equation of the contract, written out once more.
TEST(ReferenceSurface, PositionIsTheDocumentedEquation) {
    Random random(1, 0, 0);
    for (int trial = 0; trial < 100; ++trial) {
        const double R = 2, r = 0.5, u = random.uniform(), v = random.uniform();
        const std::array<double, 3> p = toDouble(position(Torus{2, 0.5f}, {u, v}));
        const double tau = 2 * M_PI;
        EXPECT_NEAR(p[0], (R + r * std::cos(tau * v)) * std::cos(tau * u),
                    1e-14);  // the double's own rounding
        EXPECT_NEAR(p[1], (R + r * std::cos(tau * v)) * std::sin(tau * u), 1e-14);
        EXPECT_NEAR(p[2], r * std::sin(tau * v), 1e-14);
    }
}

TEST(ReferenceSurface, UvAndPositionAreInverse) {
    for (const Torus& torus : someOfEachSort) {
        Random random(2, 0, 0);
        for (int trial = 0; trial < 200; ++trial) {
            const QuadVec2 given = randomUv(random, torus);
            const QuadVec3 p = position(torus, given);
            const QuadVec2 back = uv(torus, p);
            // v is recovered from numbers of size R on a circle of radius r: 2^-112 R/r, r/R = 1e-4 the worst
            EXPECT_NEAR(toDouble(back[0] - given[0]), 0, 1e-29);
            EXPECT_NEAR(toDouble(back[1] - given[1]), 0, 1e-29);
            EXPECT_LE(std::abs(toDouble(distance(torus, p))), 1e-32);
        }
    }
}

TEST(ReferenceSurface, UvStartsAtPlusXAndTheOuterEquator) {
    const Torus torus{1, 0.25f};
    const auto at = [&](Quad x, Quad y, Quad z) {
        const QuadVec2 found = uv(torus, {x, y, z});
        return std::array{toDouble(found[0]), toDouble(found[1])};
    };
    EXPECT_EQ(at(1.25, 0, 0), (std::array{0.0, 0.0}));
    EXPECT_EQ(at(1.25, -0.0, -0.0), (std::array{0.0, 0.0}));
    EXPECT_EQ(at(0, 1, 0.25), (std::array{0.25, 0.25}));
    EXPECT_EQ(at(-0.75, 0, 0), (std::array{0.5, 0.5}));
    EXPECT_EQ(at(0, -1, -0.25), (std::array{0.75, 0.75}));
    // A hair below the start of either turn stays below 1.
    const QuadVec2 seam = uv(torus, {1.25, Quad(-1e-40), Quad(-1e-40)});
    EXPECT_TRUE(seam[0] < 1 && seam[1] < 1 && seam[0] >= 0 && seam[1] >= 0);
    EXPECT_FALSE(std::signbit(at(1.25, -0.0, -0.0)[0]));
}

TEST(ReferenceSurface, TangentsAreTheDerivativesOfPosition) {
    for (const Torus& torus : someOfEachSort) {
        Random random(3, 0, 0);
        for (int trial = 0; trial < 50; ++trial) {
            const QuadVec2 at = randomUv(random, torus);
            const Tangents found = tangents(torus, position(torus, at));
            // Central differences: error h^2/6 times the third derivative, (2 pi)^3 (R + r), that is 1e-22;
            // the rounding of 2^-112 / h is smaller.
            const Quad h = 1e-12;
            const QuadVec3 du =
                sum(position(torus, {at[0] + h, at[1]}), -1, position(torus, {at[0] - h, at[1]}));
            const QuadVec3 dv =
                sum(position(torus, {at[0], at[1] + h}), -1, position(torus, {at[0], at[1] - h}));
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(toDouble(du[k] / (2 * h) - found.dPdu[k]), 0, 1e-20);
                EXPECT_NEAR(toDouble(dv[k] / (2 * h) - found.dPdv[k]), 0, 1e-20);
            }
        }
    }
}

// Outward: dPdu x dPdv points along the normal, and the distance grows by the way along it.
TEST(ReferenceSurface, NormalIsUnitOutwardAndAcrossTheTangents) {
    for (const Torus& torus : someOfEachSort) {
        Random random(4, 0, 0);
        for (int trial = 0; trial < 100; ++trial) {
            const QuadVec3 p = position(torus, randomUv(random, torus));
            const QuadVec3 n = normal(torus, p);
            const Tangents t = tangents(torus, p);
            EXPECT_NEAR(toDouble(dot(n, n) - 1), 0, 1e-32);
            EXPECT_NEAR(toDouble(dot(n, t.dPdu)), 0, 1e-31);
            EXPECT_NEAR(toDouble(dot(n, t.dPdv)), 0, 1e-31);
            const QuadVec3 cross{t.dPdu[1] * t.dPdv[2] - t.dPdu[2] * t.dPdv[1],
                                 t.dPdu[2] * t.dPdv[0] - t.dPdu[0] * t.dPdv[2],
                                 t.dPdu[0] * t.dPdv[1] - t.dPdu[1] * t.dPdv[0]};
            EXPECT_TRUE(dot(cross, n) > 0);
            const Quad way = 1e-5 * Quad(torus.minorRadius);
            EXPECT_NEAR(toDouble((distance(torus, sum(p, way, n)) - way) / way), 0, 1e-22);
        }
    }
}

TEST(ReferenceSurface, DistanceIsTheNearestPointOfTheProfile) {
    for (const Torus& torus : someOfEachSort) {
        Random random(5, 0, 0);
        for (int trial = 0; trial < 60; ++trial) {
            // every other point near the centre: inside a spindle the cusps are the nearest only there
            const Quad scale = trial % 2 == 0 ? 1 : 0.3;
            const QuadVec3 p = sum({0, 0, 0}, scale, randomPoint(random, torus));
            const double rho = std::sqrt(toDouble(p[0] * p[0] + p[1] * p[1])), z = toDouble(p[2]);
            const double R{torus.majorRadius}, r{torus.minorRadius};
            const bool inside = (rho - R) * (rho - R) + z * z < r * r;
            const double expected = (inside ? -1 : 1) * sampledDistance(torus, rho, z);
            // Samples are 2 pi r / 20000 apart; at most half of that is lost on the curve and all at a cusp.
            EXPECT_NEAR(toDouble(distance(torus, p)), expected, 2 * M_PI * r / 20000);
        }
    }
}

// r = 5/4, R = 3/4: cusps at z = +-1. At the centre they are as near as it gets; the full circle would say
// -1/2.
TEST(ReferenceSurface, DistanceInsideASpindleReachesForTheCusp) {
    const Torus spindle{0.75f, 1.25f};
    EXPECT_EQ(toDouble(distance(spindle, {0, 0, 0})), -1);
    EXPECT_EQ(toDouble(distance(spindle, {0, 0, 0.5})), -0.5);
    EXPECT_EQ(toDouble(distance(spindle, {0, 0, -0.5})), -0.5);
    EXPECT_EQ(toDouble(distance(spindle, {0, 0, -1})), 0);
    EXPECT_EQ(toDouble(distance(spindle, {0.75, 0, 0})), -1.25);
    EXPECT_EQ(toDouble(distance(spindle, {3, 0, 0})), 1);
    // on the axis above the cusp: the nearest circle is the ring's
    EXPECT_NEAR(toDouble(distance(spindle, {0, 0, 2})), std::hypot(0.75, 2) - 1.25, 1e-15);
    EXPECT_EQ(toDouble(distance({0, 2}, {0, 0, 0.5})), -1.5);
}

TEST(ReferenceSurface, DistanceHasAGradientOfLengthOne) {
    for (const Torus& torus : someOfEachSort) {
        Random random(6, 0, 0);
        for (int trial = 0; trial < 100; ++trial) {
            const QuadVec3 p = randomPoint(random, torus);
            const Quad h = 1e-12 * Quad(torus.minorRadius);
            Quad squared = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                QuadVec3 step{};
                step[k] = h;
                const Quad slope =
                    (distance(torus, sum(p, 1, step)) - distance(torus, sum(p, -1, step))) / (2 * h);
                squared = squared + slope * slope;
            }
            // h^2 times third derivatives, which are 1/(distance from the ring or the axis)^2, 1e8 at worst
            EXPECT_NEAR(toDouble(squared), 1, 1e-14) << gap(p, {0, 0, 0});
        }
    }
}

TEST(ReferenceSurface, ImplicitHasTheSignOfTheDistanceAndVanishesOnBothSheets) {
    EXPECT_EQ(toDouble(implicit({1, 0.25f}, {1, 0, 0})), 0.0625 * 0.0625 - 4 * 0.0625 + 4 - 4 + 0);
    EXPECT_EQ(toDouble(implicit({1, 0.25f}, {1.25, 0, 0})), 0);
    EXPECT_EQ(toDouble(implicit({0.75f, 1.25f}, {0.5, 0, 0})), 0);  // the inner sheet
    for (const Torus& torus : {someOfEachSort[0], someOfEachSort[1]}) {
        Random random(7, 0, 0);
        for (int trial = 0; trial < 200; ++trial) {
            const QuadVec3 p = randomPoint(random, torus);
            EXPECT_EQ(implicit(torus, p) < 0, distance(torus, p) < 0);
        }
    }
}

}  // namespace raytorus::reference
