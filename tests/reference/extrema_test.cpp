// SPDX-License-Identifier: MIT
// The clearance of a ray against a dense search for the extrema of the distance to the tube.
#include "reference/extrema.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/intersect.hpp"
#include "reference/rays.hpp"

namespace raytorus::reference {

namespace {

// The smallest |distance to the tube| over its local extrema among samples of the ray, in units of
// minorRadius.
double sampledClearance(const Torus& torus, const Ray& ray, double from, double to, int samples) {
    const BasicTorus<double> exact(torus);
    const BasicRay<double> line(ray);
    double before = 0, here = 0, smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i) {
        const double t = from + (to - from) * i / samples;
        const double next = tubeDistance(
            exact, {line.origin[0] + t * line.direction[0], line.origin[1] + t * line.direction[1],
                    line.origin[2] + t * line.direction[2]});
        if (i >= 2 && (here - before) * (next - here) <= 0) smallest = std::min(smallest, std::abs(here));
        before = here;
        here = next;
    }
    return smallest / exact.minorRadius;
}

}  // namespace

TEST(Extrema, AgreeWithADenseSearch) {
    for (const Torus& torus : {Torus{1, 0.25f}, Torus{1, 0.05f}, Torus{1, 1}, Torus{1, 1.5f}, Torus{0, 1}}) {
        for (const RayClass rayClass :
             {RayClass::camera, RayClass::inside, RayClass::equatorial, RayClass::axisParallel,
              RayClass::throughAxis, RayClass::axisAligned, RayClass::grazing}) {
            for (std::uint64_t index = 0; index < 40; ++index) {
                const RayParameters parameters{torus, 3, 1e-2, 7};
                const Ray ray = generateRay(rayClass, parameters, index).ray;
                const double reach = 30;  // covers the torus from 3 R on either side, for |direction| >= 0.5
                const int samples = 40000;
                const double sampled = sampledClearance(torus, ray, -reach, reach, samples);
                // A smooth extremum is missed by step^2/2 times the curvature, which is |d|^2/distance to the
                // ring; a kink on the axis by step |d|. |d|^2 <= 3.
                const double step = 2 * reach / samples;
                EXPECT_NEAR(intersect(torus, ray).clearance, sampled, 2 * step / double{torus.minorRadius})
                    << describeRay(rayClass, parameters, index);
            }
        }
    }
}

// Tangents at a known margin: the line passes the surface point at margin * r, on the convex side exactly
// there.
TEST(Extrema, SeeTheMarginOfGrazingRays) {
    for (double margin : {1e-2, 1e-4}) {
        for (std::uint64_t index = 0; index < 500; ++index) {
            const RayParameters parameters{{1, 0.25f}, 3, margin, 3};
            const Ray ray = generateRay(RayClass::grazing, parameters, index).ray;
            // floats of size 3 round by 2^-23 = 1.2e-7, in units of r = 1/4 that is 5e-7 a coordinate
            EXPECT_LE(intersect(parameters.torus, ray).clearance, margin + 2e-6)
                << describeRay(RayClass::grazing, parameters, index);
        }
    }
}

}  // namespace raytorus::reference
