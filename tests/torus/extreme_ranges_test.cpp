// SPDX-License-Identifier: MIT
// Where the numbers are extreme: the thinnest tubes, spindles that are nearly spheres, sizes and directions
// of every length against each other, origins on the surface and one float beside it, ends of the ray at a
// hit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hit_judge.hpp"
#include "reference/torus_reference.hpp"
#include "support/device_fixture.hpp"
#include "support/special_floats.hpp"

namespace raytorus {
namespace {

using reference::Ray;
using reference::RayClass;
using reference::Torus;

constexpr float largest = std::numeric_limits<float>::max();

class ExtremeRanges : public test::DeviceTest {
protected:
    static void expectRight(test::HitJudge& judge, const Torus& torus, const std::vector<Ray>& rays) {
        int faults = 0;
        for (const std::string& fault : judge.mismatches(torus, rays)) {
            if (!fault.empty() && ++faults <= 3) {
                ADD_FAILURE() << fault;
            }
        }
        EXPECT_EQ(faults, 0) << "of " << rays.size() << " rays";
    }
};

// Clear rays of every class, as in HitAccuracy.
TEST_F(ExtremeRanges, ThinAndThickToriAreRightOnClearRays) {
    constexpr std::uint64_t raysPerCase = 300;
    test::HitJudge judge(raysPerCase);
    for (const Torus& torus : {Torus{1, 1e-4F}, Torus{0, 1}, Torus{1, 10}, Torus{1, 1000}}) {
        std::size_t judged = 0;
        for (const RayClass rayClass : reference::allRayClasses) {
            for (const double distance : {1.5, 30.0, 1e5}) {
                reference::RayParameters parameters;
                parameters.torus = torus;
                parameters.distance = distance;
                parameters.seed = 4;
                const std::string name = fmt::format("{} R {} r {} D {}", reference::nameOf(rayClass),
                                                     torus.majorRadius, torus.minorRadius, distance);
                // The classes that start from a circle of the tube need one; hole needs room beside the axis.
                if (torus.majorRadius == 0.0F && rayClass == RayClass::hole) {
                    continue;
                }
                const auto rays = reference::generateRays(rayClass, parameters, raysPerCase);
                const test::HitTally judgement = judge.judge(torus, rays, name);
                judged += judgement.judged;
                for (const std::string& fault : judgement.faults) {
                    ADD_FAILURE() << fault;
                }
                EXPECT_EQ(judgement.faultCount, 0U) << name;
            }
        }
        fmt::print("R {} r {}: {} clear rays\n", torus.majorRadius, torus.minorRadius, judged);
        EXPECT_GT(judged, 15 * raysPerCase);
    }
}

// From so far away that a moment about the centre is rounded by as much as the torus is long: whoever tells
// by it which rays pass by has to leave room for that.
TEST_F(ExtremeRanges, RaysFromVeryFarMeetTheOuterEquator) {
    constexpr std::uint64_t raysPerCase = 2000;
    test::HitJudge judge(raysPerCase);
    for (const float minorRadius : {0.01F, 0.9F, 1.5F}) {
        for (const double distance : {1e6, 1e7, 1e8}) {
            for (const RayClass rayClass : {RayClass::equatorial, RayClass::camera}) {
                reference::RayParameters parameters;
                parameters.torus = {1.0F, minorRadius};
                parameters.distance = distance;
                parameters.seed = 7;
                SCOPED_TRACE(
                    fmt::format("{} r {} from {:g}", reference::nameOf(rayClass), minorRadius, distance));
                expectRight(judge, {1.0F, minorRadius},
                            reference::generateRays(rayClass, parameters, raysPerCase));
            }
        }
    }
}

// One float as another's multiple, saturating: t may leave what floats hold.
float times(double x, double factor) {
    const double product = x * factor;
    return static_cast<float>(std::clamp(product, -double{largest}, double{largest}));
}

// Every size against every length of the direction: t runs from 1e-33 to 1e33.
TEST_F(ExtremeRanges, SizesAndDirectionsOfAnyLengthCombine) {
    constexpr std::uint64_t raysPerCase = 40;
    test::HitJudge judge(raysPerCase);
    for (const double size : {0.81e-18, 1e-15, 3e-11, 1e-5, 1e5, 7e10, 1e15}) {
        for (const double speed : {1e-18, 1e-9, 1.0, 1e9, 0.99e18}) {
            for (const double distance : {1.5, 1e4}) {
                for (const RayClass rayClass : {RayClass::camera, RayClass::inside, RayClass::segment}) {
                    reference::RayParameters parameters;
                    parameters.distance = distance;
                    parameters.seed = 6;
                    std::vector<Ray> rays = reference::generateRays(rayClass, parameters, raysPerCase);
                    for (Ray& ray : rays) {
                        for (int i = 0; i < 3; ++i) {
                            ray.origin[i] = times(double{ray.origin[i]}, size);
                            ray.direction[i] = times(double{ray.direction[i]}, speed);
                        }
                        ray.tMin = times(double{ray.tMin}, size / speed);
                        ray.tMax = ray.tMax < largest ? times(double{ray.tMax}, size / speed) : ray.tMax;
                    }
                    expectRight(judge, {times(1.0, size), times(0.25, size)}, rays);
                }
            }
        }
    }
}

// Hits at a t that no float holds cannot be told: they are missed, and nothing non-finite comes of them.
TEST_F(ExtremeRanges, HitsBeyondTheLargestTAreMissed) {
    const float size = 1e18F * 0.8F;
    const std::vector<Ray> rays = {{{-1e23F, 0, 0}, 0, {1.0e-18F, 0, 0}, infinity},
                                   {{-1e30F, 0, 0}, 0, {1.0e-18F, 0, 0}, largest},
                                   {{-1e37F, 0, 0}, 0, {1.0e-18F, 0, 0}, infinity},
                                   {{-1e37F, 1e37F, 0}, -infinity, {1.0e-18F, -1.0e-18F, 0}, infinity},
                                   {{1e37F, 0, 0}, -infinity, {1.0e-18F, 0, 0}, infinity}};
    test::HitJudge judge(rays.size());
    expectRight(judge, {size, size / 4}, rays);
    // So far away that the ends' distances from the torus would be differences of infinities.
    const std::vector<Ray> further = {{{0, 0, -0x1.cf3p109F}, -infinity, {0, 0, -0x1.5p-59F}, infinity},
                                      {{0, 0, 0x1.356p109F}, -infinity, {0, 0, -0x1.afp-59F}, infinity},
                                      {{-0x1p120F, 0, 0}, -largest, {-0x1.3p-59F, 0, 0}, largest}};
    expectRight(judge, {1, 15}, further);
}

// The solid's own floats: R + r and R - r are exact here, so the origin is on the surface to the last bit.
TEST_F(ExtremeRanges, OriginsOnTheSurfaceAndOneFloatBesideIt) {
    for (const float minorRadius : {0x1p-10F, 0.25F, 0.75F, 1.0F, 1.5F}) {
        const Torus torus{1, minorRadius};
        std::vector<Ray> rays;
        for (const float rho : {1 + minorRadius, 1 - minorRadius}) {
            for (const float x : {rho, std::nextafter(rho, -9.0F), std::nextafter(rho, 9.0F)}) {
                for (const float dx : {1.0F, -1.0F, 0.5F, -0.125F}) {
                    rays.push_back({{x, 0, 0}, 0, {dx, 0, 0}, infinity});
                    rays.push_back({{0, x, 0}, 0, {0.25F, dx, -0.5F}, infinity});
                    rays.push_back({{0, x, 0}, -infinity, {0.25F, dx, -0.5F}, 0});
                    rays.push_back({{-x, 0, 0}, 0x1p-10F, {dx, 0.0625F, 1}, infinity});
                }
            }
        }
        for (const float z :
             {minorRadius, std::nextafter(minorRadius, 0.0F), std::nextafter(minorRadius, 9.0F)}) {
            for (const float dz : {1.0F, -1.0F, 0.25F, -0.5F}) {
                rays.push_back({{1, 0, z}, 0, {0, 0, dz}, infinity});
                rays.push_back({{0, -1, z}, 0, {0.25F, 0.125F, dz}, infinity});
            }
        }
        test::HitJudge judge(rays.size());
        expectRight(judge, torus, rays);
    }
}

// Hits at 1.75, 2.25, 3.75 and 4.25, exactly. At an end a hit may go either way; one float within it must be
// there, as far as float32 knows, and one float beyond it must not.
TEST_F(ExtremeRanges, EndsAtAHitAndOneFloatBesideIt) {
    std::vector<Ray> rays;
    for (const float t : {1.75F, 2.25F, 3.75F, 4.25F}) {
        for (const float end : {t, std::nextafter(t, 0.0F), std::nextafter(t, 9.0F), t - 1e-4F, t + 1e-4F}) {
            rays.push_back({{3, 0, 0}, end, {-1, 0, 0}, infinity});
            rays.push_back({{3, 0, 0}, -infinity, {-1, 0, 0}, end});
            rays.push_back({{3, 0, 0}, -end, {1, 0, 0}, largest});
            rays.push_back({{3, 0, 0}, -largest, {1, 0, 0}, -end});
            rays.push_back({{3, 0, 0}, end, {-1, 0, 0}, end});
            rays.push_back({{3, 0, 0}, 2, {-1, 0, 0}, std::max(end, 2.0F)});
        }
    }
    rays.push_back({{3, 0, 0}, -infinity, {-1, 0, 0}, infinity});
    rays.push_back({{3, 0, 0}, -largest, {-1, 0, 0}, largest});
    rays.push_back({{3, 0, 0}, -infinity, {1, 0, 0}, -largest});
    rays.push_back({{3, 0, 0}, largest, {-1, 0, 0}, infinity});
    rays.push_back({{0, 0, 0}, -1, {1, 0, 0}, 1});
    test::HitJudge judge(rays.size());
    expectRight(judge, {1, 0.25F}, rays);
}

// From up to 8 units away, where an origin is not yet a far one, t has an ulp of 5e-7: an end one float
// before or behind a hit of a thin tube does not go either way. The foot that a search begins with is not
// right enough for that.
TEST_F(ExtremeRanges, EndsBesideTheHitsOfOriginsThatAreNotYetFar) {
    const Torus torus{1, 0.01F};
    reference::RayParameters parameters;
    parameters.torus = torus;
    parameters.distance = 7.5;
    parameters.seed = 8;
    std::vector<Ray> rays;
    for (Ray ray : reference::generateRays(RayClass::camera, parameters, 4000)) {
        ray.tMin = 0;
        ray.tMax = infinity;
        const reference::Intersections truth = reference::intersect(torus, ray);
        for (int i = 0; i < truth.count; ++i) {
            const auto t = static_cast<float>(truth.hits[static_cast<std::size_t>(i)].t);
            for (const float end : {std::nextafter(t, 0.0F), std::nextafter(t, infinity)}) {
                Ray until = ray;
                until.tMax = end;
                Ray since = ray;
                since.tMin = end;
                rays.insert(rays.end(), {until, since});
            }
        }
    }
    ASSERT_GT(rays.size(), 4000U);
    test::HitJudge judge(rays.size());
    expectRight(judge, torus, rays);
}

}  // namespace
}  // namespace raytorus
