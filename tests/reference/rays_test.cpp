// SPDX-License-Identifier: MIT
// The ray generators: they are reproducible, each keeps its promise, and each of their branches is alive.
#include "reference/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace raytorus::reference {

namespace {

const Torus tori[] = {{1, 0.25f}, {1, 1}, {1, 1.5f}, {0, 1}, {1, 1e-4f}};

bool sameBits(const Ray& a, const Ray& b) {
    return std::memcmp(&a, &b, sizeof(Ray)) == 0;
}

Quad squared(Quad x) {
    return x * x;
}

// All rays of a class for each torus, with their branch.
template <class Check>
void forEachRay(RayClass rayClass, Check check) {
    for (const Torus& torus : tori) {
        for (const double D : {3.0, 1000.0}) {
            const RayParameters parameters{torus, D, 1e-3, 5};
            for (std::uint64_t index = 0; index < 200; ++index) {
                const GeneratedRay generated = generateRay(rayClass, parameters, index);
                SCOPED_TRACE(describeRay(rayClass, parameters, index));
                check(parameters, generated.ray, generated.branch);
            }
        }
    }
}

}  // namespace

TEST(Rays, EveryBranchIsAlive) {
    for (const RayClass rayClass : allRayClasses) {
        std::vector<int> counts(static_cast<std::size_t>(branchCount(rayClass)));
        forEachRay(rayClass, [&](const RayParameters&, const Ray&, int branch) {
            ASSERT_LT(static_cast<std::size_t>(branch), counts.size());
            ++counts[static_cast<std::size_t>(branch)];
        });
        // 2000 rays over at most 6 branches: 333 expected, and 200 is 7 standard deviations below
        for (std::size_t branch = 0; branch < counts.size(); ++branch) {
            EXPECT_GE(counts[branch], 200) << nameOf(rayClass) << " branch " << branch;
        }
    }
}

TEST(Rays, HaveDistinctNamesInTheOrderOfTheEnumeration) {
    int expected = 0;
    for (const RayClass rayClass : allRayClasses)
        EXPECT_EQ(static_cast<int>(rayClass), expected++);
    EXPECT_STREQ(nameOf(RayClass::camera), "camera");
    EXPECT_STREQ(nameOf(RayClass::leaving), "leaving");
    EXPECT_STREQ(nameOf(RayClass::segment), "segment");
}

TEST(Rays, FollowFromTheirParametersAlone) {
    const RayParameters parameters{{1, 0.25f}, 3, 1e-4, 42};
    RayParameters otherSeed = parameters;
    otherSeed.seed = 43;
    for (const RayClass rayClass : allRayClasses) {
        const std::vector<Ray> rays = generateRays(rayClass, parameters, 10);
        EXPECT_TRUE(sameBits(rays[7], generateRay(rayClass, parameters, 7).ray)) << nameOf(rayClass);
        EXPECT_FALSE(sameBits(rays[7], rays[8])) << nameOf(rayClass);
        EXPECT_FALSE(sameBits(rays[7], generateRay(rayClass, otherSeed, 7).ray)) << nameOf(rayClass);
    }
}

// A stream that changes would silently replace every test's rays: pinned, to the bit.
TEST(Rays, AreTheSameOnEveryPlatform) {
    std::uint64_t hash = 1469598103934665603u;  // FNV-1a
    for (const RayClass rayClass : allRayClasses) {
        for (const Ray& ray : generateRays(rayClass, {}, 100)) {
            unsigned char bytes[sizeof(Ray)];
            std::memcpy(bytes, &ray, sizeof ray);
            for (const unsigned char byte : bytes)
                hash = (hash ^ byte) * 1099511628211u;
        }
    }
    EXPECT_EQ(hash, 16799530447702160847u);
}

TEST(Rays, AreValidAndFinite) {
    for (const RayClass rayClass : allRayClasses) {
        forEachRay(rayClass, [](const RayParameters&, const Ray& ray, int) {
            float longest = 0;
            for (int k = 0; k < 3; ++k) {
                EXPECT_TRUE(std::isfinite(ray.origin[k]) && std::isfinite(ray.direction[k]));
                longest = std::max(longest, std::abs(ray.direction[k]));
            }
            EXPECT_GT(longest, 0);
            EXPECT_GE(ray.tMin, 0);
            EXPECT_LE(ray.tMin, ray.tMax);
        });
    }
}

TEST(Rays, CameraStartsAtTheDistanceAndAimsAtTheBoundingSphere) {
    int hits = 0, misses = 0;
    forEachRay(RayClass::camera, [&](const RayParameters& parameters, const Ray& ray, int branch) {
        const QuadVec3 o = toQuad(ray.origin), d = toQuad(ray.direction);
        const double D = originDistance(parameters);
        EXPECT_NEAR(toDouble(squareRoot(dot(o, o))), D, 2e-7 * D);  // three floats' rounding
        const Quad alongSquared = squared(dot(o, d)) / dot(d, d);
        const double passes = std::sqrt(std::abs(toDouble(dot(o, o) - alongSquared)));
        EXPECT_LE(passes,
                  double{parameters.torus.majorRadius} + double{parameters.torus.minorRadius} + 3e-7 * D);
        const bool hit = intersect(parameters.torus, ray).count > 0;
        (hit ? hits : misses) += 1;
        // floats cannot aim at a tube thinner than their rounding
        if (branch == 1 && double{parameters.torus.minorRadius} > 1e-5 * D) {
            EXPECT_TRUE(hit || intersect(parameters.torus, ray).clearance < 1e-2);
        }
        EXPECT_EQ(std::isinf(ray.tMax), branch != 2);
    });
    EXPECT_GE(hits, 200);
    EXPECT_GE(misses, 200);
}

TEST(Rays, InsideStartsInTheSolid) {
    forEachRay(RayClass::inside, [](const RayParameters& parameters, const Ray& ray, int) {
        const Intersections found = intersect(parameters.torus, ray);
        // the thin torus' r of 1e-4 is only a thousand floats wide at R = 1
        EXPECT_TRUE(found.startsInside || found.startClearance < 2e-3);
    });
}

TEST(Rays, HoleStartsOutsideNearTheAxis) {
    forEachRay(RayClass::hole, [](const RayParameters& parameters, const Ray& ray, int branch) {
        const Torus& torus = parameters.torus;
        EXPECT_FALSE(intersect(torus, ray).startsInside);
        const double rho = std::hypot(ray.origin[0], ray.origin[1]);
        EXPECT_LE(rho, std::max(0.995 * (torus.majorRadius - torus.minorRadius), 0.011 * torus.majorRadius));
        EXPECT_EQ(ray.origin[2] >= 0, branch == 0);
    });
}

TEST(Rays, EquatorialStaysInThePlane) {
    int negativeZeros = 0;
    forEachRay(RayClass::equatorial, [&](const RayParameters&, const Ray& ray, int) {
        EXPECT_EQ(ray.origin[2], 0);
        EXPECT_EQ(ray.direction[2], 0);
        negativeZeros += std::signbit(ray.direction[2]) && !std::signbit(ray.origin[2]) ? 1 : 0;
    });
    EXPECT_GE(negativeZeros, 100);
}

TEST(Rays, AxisParallelRunsAlongZTowardsTheTorus) {
    int negativeZeros = 0;
    forEachRay(RayClass::axisParallel, [&](const RayParameters&, const Ray& ray, int branch) {
        EXPECT_EQ(ray.direction[0], 0);
        EXPECT_EQ(ray.direction[1], 0);
        EXPECT_EQ(std::abs(ray.direction[2]), 1);
        EXPECT_LT(ray.origin[2] * ray.direction[2], 0);
        EXPECT_EQ(ray.origin[0] == 0 && ray.origin[1] == 0, branch == 2);
        EXPECT_TRUE(branch == 2 || (ray.direction[2] < 0) == (branch == 0));
        negativeZeros += std::signbit(ray.direction[0]) ? 1 : 0;
    });
    EXPECT_GE(negativeZeros, 100);
}

// The line meets the axis where the moment about it vanishes.
TEST(Rays, ThroughAxisMeetsItExactlyOrBarelyNot) {
    int exact[2] = {}, total[2] = {}, high = 0, low = 0;
    forEachRay(RayClass::throughAxis, [&](const RayParameters& parameters, const Ray& ray, int branch) {
        const QuadVec3 o = toQuad(ray.origin), d = toQuad(ray.direction);
        const Quad moment = o[0] * d[1] - o[1] * d[0];
        ++total[branch];
        exact[branch] += moment == 0 ? 1 : 0;
        EXPECT_LE(std::abs(toDouble(moment)), 2e-7 * originDistance(parameters));
        EXPECT_TRUE(o[0] * d[0] + o[1] * d[1] < 0);  // towards it
        const double meetsAt = toDouble(o[2] - o[0] / d[0] * d[2]);
        high += meetsAt > 0.5 ? 1 : 0;
        low += meetsAt < -0.5 ? 1 : 0;
    });
    EXPECT_GE(high, 200);
    EXPECT_GE(low, 200);
    EXPECT_EQ(exact[0], total[0]);
    EXPECT_LT(exact[1], total[1] / 2);
}

TEST(Rays, ThroughCentreMeetsItExactlyOrBarelyNot) {
    int exact[2] = {}, total[2] = {};
    forEachRay(RayClass::throughCentre, [&](const RayParameters&, const Ray& ray, int branch) {
        const QuadVec3 o = toQuad(ray.origin), d = toQuad(ray.direction);
        ++total[branch];
        exact[branch] += o[0] * d[1] == o[1] * d[0] && o[1] * d[2] == o[2] * d[1] ? 1 : 0;
        EXPECT_TRUE(dot(o, d) < 0);
    });
    EXPECT_EQ(exact[0], total[0]);
    EXPECT_LT(exact[1], total[1] / 2);
}

TEST(Rays, LeavingStartsOnTheSurface) {
    forEachRay(RayClass::leaving, [](const RayParameters& parameters, const Ray& ray, int branch) {
        const double r{parameters.torus.minorRadius};
        const double offset[3] = {0, 1e-4, -1e-4};
        const QuadVec3 o = toQuad(ray.origin);
        // floats of size R round by 6e-8
        EXPECT_NEAR(toDouble(distance(parameters.torus, o)), offset[branch] * r, 2e-7 * (1 + r));
        EXPECT_FLOAT_EQ(ray.tMin, static_cast<float>(1e-3 * r));
        const double outwards = toDouble(dot(normal(parameters.torus, o), toQuad(ray.direction)));
        // r = 1e-4: the normal is 1e-7 / r off
        EXPECT_TRUE(std::abs(outwards) < 1e-2 || (outwards < 0) == (branch == 2));
    });
}

TEST(Rays, AxisAlignedHasZerosOfBothSigns) {
    int negative = 0, positive = 0;
    forEachRay(RayClass::axisAligned, [&](const RayParameters&, const Ray& ray, int branch) {
        int zeros = 0;
        for (const float component : ray.direction) {
            if (component != 0) continue;
            ++zeros;
            (std::signbit(component) ? negative : positive) += 1;
        }
        EXPECT_EQ(zeros, branch < 3 ? 2 : 1);
        EXPECT_EQ(ray.direction[branch % 3] == 0, branch >= 3);
    });
    EXPECT_GE(negative, 1000);
    EXPECT_GE(positive, 1000);
}

TEST(Rays, NonUnitSpansTheDecades) {
    double shortest = 1, longest = 1;
    forEachRay(RayClass::nonUnit, [&](const RayParameters&, const Ray& ray, int branch) {
        const QuadVec3 d = toQuad(ray.direction);
        const double length = toDouble(squareRoot(dot(d, d)));
        EXPECT_EQ(length < 1, branch == 0);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    });
    EXPECT_LE(shortest, 1e-16);
    EXPECT_GE(longest, 1e16);
}

TEST(Rays, GrazingPassesTheSurfaceAtTheMargin) {
    int total = 0, beyond = 0;
    forEachRay(RayClass::grazing, [&](const RayParameters& parameters, const Ray& ray, int) {
        const double D = originDistance(parameters), r{parameters.torus.minorRadius};
        // floats at the distance D round by 6e-8 D in each coordinate, and the direction's 6e-8 acts over D
        const double margin = parameters.margin + 3e-7 * D / r;
        ++total;
        beyond += intersect(parameters.torus, ray).clearance > margin ? 1 : 0;
    });
    // Along the two asymptotic directions of the inner half the distance is flat to the second order, and the
    // rounding of a far origin can undo its extremum: rare, since few tangents run so.
    EXPECT_LE(beyond, total / 200);
}

TEST(Rays, SegmentsEndBeforeBetweenAndBehind) {
    int counts[5] = {};
    forEachRay(RayClass::segment, [&](const RayParameters& parameters, const Ray& ray, int branch) {
        EXPECT_TRUE(std::isfinite(ray.tMax));
        const Intersections found = intersect(parameters.torus, ray);
        EXPECT_TRUE(branch != 1 || found.count == 0);
        EXPECT_EQ(ray.tMin > 0, branch != 1);
        ++counts[found.count];
    });
    for (int count = 0; count < 4; ++count)
        EXPECT_GE(counts[count], 10) << count;
}

TEST(HexFloats, BringEveryRayBack) {
    for (const RayClass rayClass : allRayClasses) {
        forEachRay(rayClass, [](const RayParameters& parameters, const Ray& ray, int) {
            const std::optional<TorusAndRay> back = parseHexFloats(hexFloats(parameters.torus, ray));
            ASSERT_TRUE(back.has_value());
            EXPECT_TRUE(sameBits(back->ray, ray));
            EXPECT_EQ(back->torus.majorRadius, parameters.torus.majorRadius);
            EXPECT_EQ(back->torus.minorRadius, parameters.torus.minorRadius);
        });
    }
}

TEST(Rays, AreDescribedSoThatTheyCanBeReplayed) {
    const RayParameters parameters{{1, 0.25f}, 5, 1e-3, 42};
    const std::string text = describeRay(RayClass::hole, parameters, 17);
    EXPECT_EQ(text.substr(0, 4), "hole");
    EXPECT_NE(text.find("seed 42 index 17"), std::string::npos) << text;
    const std::optional<TorusAndRay> back = parseHexFloats(text.substr(text.find(": ") + 2));
    ASSERT_TRUE(back.has_value()) << text;
    EXPECT_TRUE(sameBits(back->ray, generateRay(RayClass::hole, parameters, 17).ray));
}

TEST(HexFloats, RefuseWhatIsNotARay) {
    EXPECT_EQ(hexFloats({1, 0.25f}, {{-5, 0, -0.0f}, 0, {1, 0, 0}, std::numeric_limits<float>::infinity()}),
              "0x1p+0 0x1p-2  -0x1.4p+2 0x0p+0 -0x0p+0 0x0p+0  0x1p+0 0x0p+0 0x0p+0 inf");
    EXPECT_TRUE(parseHexFloats("1 .25 -5 0 0 0 1 0 0 inf").has_value());
    EXPECT_FALSE(parseHexFloats("").has_value());
    EXPECT_FALSE(parseHexFloats("1 .25 -5 0 0 0 1 0 0").has_value());
    EXPECT_FALSE(parseHexFloats("1 .25 -5 0 0 0 1 0 0 inf 3").has_value());
    EXPECT_FALSE(parseHexFloats("1 .25 -5 0 0 0 1 0 0 many").has_value());
}

}  // namespace raytorus::reference
