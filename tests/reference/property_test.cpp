// SPDX-License-Identifier: MIT
// The reference intersection on random rays of every class, against the exact distance to the solid: each hit
// lies on the surface, and a certificate proves that there is no other.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/double_double.hpp"
#include "reference/intersect.hpp"
#include "reference/rays.hpp"

namespace raytorus::reference {

namespace {

const Torus everySort[] = {{1, 1e-4f}, {1, 0.01f}, {1, 0.25f}, {1, 0.999f},
                           {1, 1},     {1, 1.5f},  {1, 1000},  {0, 1}};

QuadVec3 pointAt(const PreciseRay& ray, Quad t) {
    return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1],
            ray.origin[2] + t * ray.direction[2]};
}

enum class Side { inside, outside, both };

// On which sides the ray lies between two parameters. The distance is 1-Lipschitz, so a step of its own value
// cannot pass the surface: the sides that are met are all there are, whatever lies between the points.
Side sideBetween(const PreciseTorus& torus, const PreciseRay& ray, Quad from, Quad to) {
    const Quad length = squareRoot(dot(ray.direction, ray.direction));
    bool inside = false, outside = false;
    int steps = 0;
    // Near a surface that is met at the cosine c each step is 1 - c of the way left: 20000 steps reach the
    // 1e-9 r left out about a hit for c = 1e-3, the least that rays of a clearance of 1e-6 have.
    for (Quad t = from; t < to; ++steps) {
        const Quad d = distance(torus, pointAt(ray, t));
        (d < 0 ? inside : outside) = true;
        if ((inside && outside) || steps > 20000) return Side::both;
        t = t + magnitude(d) / length;
    }
    return inside ? Side::inside : Side::outside;
}

void expectComplete(const Torus& torus, const Ray& given, const Intersections& found) {
    const PreciseRay ray(given);
    const PreciseTorus exact(torus);
    const Quad r = exact.minorRadius, length = squareRoot(dot(ray.direction, ray.direction));
    // A hit's neighbourhood that the certificate leaves out: there the distance is proved by its two sides.
    const Quad skipped = 1e-9 * r / length;
    const Quad reach = (squareRoot(dot(ray.origin, ray.origin)) + 2 * (exact.majorRadius + r)) / length;
    const Quad last = ray.tMax < reach ? ray.tMax : reach;
    bool inside = found.startsInside;
    Quad from = ray.tMin;
    for (int i = 0; i <= found.count; ++i) {
        const Quad to = i < found.count ? found.hits[static_cast<std::size_t>(i)].t - skipped : last;
        if (from < to) {
            EXPECT_EQ(sideBetween(exact, ray, from, to), inside ? Side::inside : Side::outside)
                << "before hit " << i;
        }
        if (i == found.count) break;
        const Hit& hit = found.hits[static_cast<std::size_t>(i)];
        EXPECT_TRUE(hit.t >= ray.tMin);
        EXPECT_TRUE(hit.t <= ray.tMax);
        EXPECT_EQ(hit.entering, !inside) << "hit " << i;
        EXPECT_EQ(hit.entering, dot(normal(exact, hit.position), ray.direction) < 0) << "hit " << i;
        inside = !inside;
        from = hit.t + skipped;
    }
}

void expectOnSurface(const Torus& torus, const Ray& given, const Intersections& found) {
    const PreciseRay ray(given);
    const PreciseTorus exact(torus);
    const Quad size = exact.majorRadius + exact.minorRadius;
    const Quad startDistance = squareRoot(dot(ray.origin, ray.origin));
    for (int i = 0; i < found.count; ++i) {
        const Hit& hit = found.hits[static_cast<std::size_t>(i)];
        const double offSurface = toDouble(magnitude(distance(exact, hit.position)) / size);
        // The quartic's rounding is 2^-108 of size^4, its slope at a root that crosses at angle c is 8 r c
        // size^2. The angle is sqrt(2 clearance) at least, 1e-3 here, and r is 1e-4 of the size at least.
        const Quad r = exact.minorRadius;
        // At a cusp both sheets meet and the quartic has a double root: half of its bits.
        const QuadVec3& p = hit.position;
        const bool atCusp = r >= exact.majorRadius && p[0] * p[0] + p[1] * p[1] < 1e-12 * size * size;
        EXPECT_LE(offSurface, atCusp ? 1e-16 : 1e-24) << "hit " << i;
        EXPECT_LE(std::abs(toDouble(implicit(exact, hit.position) / (size * size * size * r))), 1e-19)
            << "hit " << i;
        // t and the position are the same point but for the rounding of t, 2^-112 of the way
        const QuadVec3 fromT = pointAt(ray, hit.t);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(std::abs(toDouble((fromT[k] - hit.position[k]) / (startDistance + size))), 1e-32);
        }
    }
}

}  // namespace

TEST(ReferenceProperty, EveryHitLiesOnTheSurfaceAndNoneIsMissing) {
    int clear = 0, total = 0, hits[5] = {};
    for (const Torus& torus : everySort) {
        for (const double D : {3.0, 1000.0, 1e6}) {
            for (const RayClass rayClass : allRayClasses) {
                // What runs along the surface has no certificate in a bounded number of steps ...
                if (passesByMargin(rayClass) && rayClass != RayClass::grazing) continue;
                const RayParameters parameters{torus, D, 1e-2, 20};
                for (std::uint64_t index = 0; index < 100; ++index) {
                    const Ray ray = generateRay(rayClass, parameters, index).ray;
                    const Intersections found = intersect(torus, ray);
                    SCOPED_TRACE(describeRay(rayClass, parameters, index));
                    ++total;
                    ++hits[found.count];
                    // ... nor has what is nearly a tangent.
                    if (found.clearance < 1e-6 || found.endClearance() < 1e-6) continue;
                    ++clear;
                    expectOnSurface(torus, ray, found);
                    expectComplete(torus, ray, found);
                    if (testing::Test::HasFailure()) return;  // one ray to replay is enough
                }
            }
        }
    }
    // The test must have had something to judge.
    EXPECT_GE(clear, total / 2);
    for (int count = 0; count <= 4; ++count)
        EXPECT_GE(hits[count], 10) << count << " hits";
    RecordProperty("clearRays", clear);
    RecordProperty("rays", total);
}

// From outside the count is even, from inside odd, for every ray that runs to infinity, tangent or not.
TEST(ReferenceProperty, TheCountHasTheParityOfTheStart) {
    for (const Torus& torus : everySort) {
        for (const RayClass rayClass : allRayClasses) {
            for (std::uint64_t index = 0; index < 500; ++index) {
                const RayParameters parameters{torus, 3, index % 2 == 0 ? 0 : 1e-7, 21};
                Ray ray = generateRay(rayClass, parameters, index).ray;
                ray.tMax = std::numeric_limits<float>::infinity();
                const Intersections found = intersect(torus, ray);
                // 1e-20 r: on the surface itself, in or out is a matter of the last rounding
                if (found.startClearance < 1e-20) continue;
                EXPECT_EQ(found.count % 2 == 1, found.startsInside)
                    << describeRay(rayClass, parameters, index);
            }
        }
    }
}

// Lengths and directions scaled by powers of two: the same bits, scaled.
TEST(ReferenceProperty, ScalesExactlyByPowersOfTwo) {
    for (const Torus& torus : everySort) {
        for (const RayClass rayClass :
             {RayClass::camera, RayClass::inside, RayClass::throughAxis, RayClass::segment}) {
            for (std::uint64_t index = 0; index < 20; ++index) {
                const RayParameters parameters{torus, 10, 0, 22};
                const Ray ray = generateRay(rayClass, parameters, index).ray;
                const Intersections found = intersect(torus, ray);
                for (const int length : {-50, 40}) {     // radii of 1e-15 and 1e12
                    for (const int speed : {-60, 60}) {  // directions of 1e-18 and 1e18
                        Torus scaledTorus{std::ldexp(torus.majorRadius, length),
                                          std::ldexp(torus.minorRadius, length)};
                        Ray scaled = ray;
                        for (int k = 0; k < 3; ++k) {
                            scaled.origin[k] = std::ldexp(scaled.origin[k], length);
                            scaled.direction[k] = std::ldexp(scaled.direction[k], speed);
                        }
                        scaled.tMin = std::ldexp(scaled.tMin, length - speed);
                        scaled.tMax = std::ldexp(scaled.tMax, length - speed);
                        const Intersections same = intersect(scaledTorus, scaled);
                        SCOPED_TRACE(describeRay(rayClass, parameters, index));
                        ASSERT_EQ(same.count, found.count);
                        EXPECT_EQ(same.clearance, found.clearance);
                        for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
                            EXPECT_TRUE(same.hits[i].t == timesPowerOfTwo(found.hits[i].t, length - speed));
                            EXPECT_TRUE(same.hits[i].position[0] ==
                                        timesPowerOfTwo(found.hits[i].position[0], length));
                        }
                    }
                }
            }
        }
    }
}

// The verdict does not hang on the number type: with fewer bits the clear rays come out the same.
template <class Real>
void expectSameVerdicts(double smallestClearance, double largestError) {
    int compared = 0;
    for (const Torus& torus : everySort) {
        for (const RayClass rayClass : allRayClasses) {
            for (std::uint64_t index = 0; index < 200; ++index) {
                const RayParameters parameters{torus, 100, 1e-2, 23};
                const Ray ray = generateRay(rayClass, parameters, index).ray;
                const Intersections quad = intersect(torus, ray);
                if (quad.clearance < smallestClearance || quad.endClearance() < smallestClearance) continue;
                const BasicIntersections<Real> same = intersectAs<Real>(torus, ray);
                SCOPED_TRACE(describeRay(rayClass, parameters, index));
                ++compared;
                ASSERT_EQ(same.count, quad.count);
                EXPECT_EQ(same.startsInside, quad.startsInside);
                EXPECT_NEAR(same.clearance, quad.clearance, 1e-6 * quad.clearance);
                for (std::size_t i = 0; i < static_cast<std::size_t>(same.count); ++i) {
                    EXPECT_EQ(same.hits[i].entering, quad.hits[i].entering);
                    for (std::size_t k = 0; k < 3; ++k) {
                        EXPECT_NEAR(toDouble(same.hits[i].position[k]), toDouble(quad.hits[i].position[k]),
                                    largestError * (double{torus.majorRadius} + double{torus.minorRadius}));
                    }
                }
            }
        }
    }
    EXPECT_GE(compared, 8000);
}

// 2^-64 of a quartic of size 1 is 5e-20, in units of the thinnest r^2 it is 5e-12: 1e-6 is clear enough to
// count, while the place has half the bits at a cusp of a spindle, where two sheets meet.
TEST(ReferenceProperty, ComesOutTheSameInLongDouble) {
    expectSameVerdicts<long double>(1e-6, 1e-8);
}

TEST(ReferenceProperty, ComesOutTheSameInDoubleDouble) {
    expectSameVerdicts<DoubleDouble>(1e-12, 1e-14);
}

}  // namespace raytorus::reference
