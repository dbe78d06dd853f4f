// SPDX-License-Identifier: MIT
// Rays by name: those on which other programs' tori have been tested or found wrong, and those that hold
// every special position a line can have to a torus. Each is judged by the reference, however near to a
// tangent; where a number is published, by that too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

#include "hit_judge.hpp"
#include "support/device_fixture.hpp"
#include "support/special_floats.hpp"

namespace raytorus {
namespace {

struct StressRay {
    const char* name;
    reference::Torus torus;
    reference::Ray ray;
    std::vector<double> published = {};  ///< distances along the ray to some of its hits
    double tolerance = 0.0;
    int count = -1;  ///< of hits, if that is known without any reference
};

void PrintTo(const StressRay& row, std::ostream* out) {
    *out << row.name;
}

class StressRays : public test::DeviceTest, public testing::WithParamInterface<StressRay> {
protected:
    static void SetUpTestSuite() { judge = std::make_unique<test::HitJudge>(1); }
    static void TearDownTestSuite() { judge.reset(); }

    static std::unique_ptr<test::HitJudge> judge;
};

std::unique_ptr<test::HitJudge> StressRays::judge;

TEST_P(StressRays, AreMetByAllThreeFunctions) {
    const StressRay& row = GetParam();
    EXPECT_EQ(judge->mismatches(row.torus, {row.ray}), std::vector<std::string>{""});
    // The hits are the reference's: what is published is held against those.
    const reference::Intersections truth = reference::intersect(row.torus, row.ray);
    const reference::QuadVec3 d = reference::toQuad(row.ray.direction);
    const double length = std::sqrt(reference::toDouble(reference::dot(d, d)));
    for (const double distance : row.published) {
        double nearest = infinity;
        for (int k = 0; k < truth.count; ++k) {
            const double at = length * reference::toDouble(truth.hits[static_cast<std::size_t>(k)].t);
            nearest = std::min(nearest, std::abs(at - distance));
        }
        EXPECT_LE(nearest, row.tolerance) << "no hit at " << distance;
    }
    if (row.count >= 0) {
        EXPECT_EQ(truth.count, row.count);
    }
}

// What it costs to round numbers near 1000 to float32: 3e-5 an origin's coordinate and 3000 * 3e-8 a
// direction's, divided by the sine of some 2 degrees between the ray and the tube.
constexpr double thinRing = 5e-3;

// VecGeom, test/unit_tests/TestTorus2.cpp (CERN, 2014 to 2024): R = 100, r = 90; two cooling pipes of a
// detector, far thinner than they are wide; and "bug 810".
const StressRay vecGeom[] = {
    {"vecGeomThinRing",
     {1640, 6},
     {{1230.993171F, 1078.075896F, -2.947036F}, -infinity, {-0.646752F, -0.762700F, -0.000012F}, infinity},
     {-8.9896, 1.57856004146444523, 3235.2362263361181, 3245.75958394709075},
     thinRing,
     4},
    {"vecGeomThinRingFromOutside",
     {164, 0.7F},
     {{-652.200808F, 359.142298F, -1.826441F}, 0, {0.958700F, -0.284408F, 0.002748F}, infinity}},
    {"vecGeomInwards", {100, 90}, {{240, 0, 0}, 0, {-1, 0, 0}, infinity}, {50}, 0},
    {"vecGeomInwardsFromMinusY", {100, 90}, {{0, -240, 0}, 0, {0, 1, 0}, infinity}, {50}, 0},
    {"vecGeomDownTheAxis", {100, 90}, {{0, 0, 240}, 0, {0, 0, -1}, infinity}, {}, 0, 0},
    {"vecGeomAway", {100, 90}, {{240, 0, 0}, 0, {0.70710678F, 0.70710678F, 0}, infinity}, {}, 0, 0},
    {"vecGeomOutwardsFromWithin", {100, 90}, {{130, 0, 0}, 0, {1, 0, 0}, infinity}, {60}, 0, 1},
    {"vecGeomInwardsFromWithin", {100, 90}, {{0, 110, 0}, 0, {0, -1, 0}, infinity}, {100}, 0, 3},
    {"vecGeomUpwardsALittleTilted", {100, 90}, {{100, 0, 0}, 0, {1e-5F, 1e-6F, 1}, infinity}, {90}, 1e-6, 1},
    {"vecGeomUpwardsFromBesideTheRing", {100, 90}, {{90, 0, 0}, 0, {1e-5F, 1e-5F, 1}, infinity}},
    {"vecGeomUpwardsFourTimesTilted", {100, 90}, {{90, 0, 0}, 0, {4e-5F, 4e-5F, 1}, infinity}},
    {"vecGeomFromTheOuterEquator", {100, 90}, {{190, 0, 0}, 0, {1, 0, 0}, infinity}},
    {"vecGeomIntoTheOuterEquator", {100, 90}, {{190, 0, 0}, 0, {-1, 0, 0}, infinity}},
    {"vecGeomFromTheInnerEquator", {100, 90}, {{0, 10, 0}, 0, {0, 1, 0}, infinity}},
    {"vecGeomBug810Cladding", {100, 10}, {{0, 0, 0}, 0, {0, 1, 0}, infinity}, {90, 110}, 0, 2},
    {"vecGeomBug810CoreFromTheCladding", {100, 5}, {{0, 90, 0}, 0, {0, 1, 0}, infinity}, {5, 15}, 0, 2},
    {"vecGeomBesideTheEquator", {1000, 100}, {{-1200, 0, 1.1F}, 0, {1, 0, 0}, infinity}},
};

const StressRay others[] = {
    // TrenchBroom, vecmath's intersection_test.cpp (2019): every expected distance is 4, every ray is along
    // an axis.
    {"trenchBroomAlongY", {5, 1}, {{0, 0, 0}, 0, {0, 1, 0}, infinity}, {4}, 0, 2},
    {"trenchBroomAlongX", {5, 1}, {{0, 0, 0}, 0, {1, 0, 0}, infinity}, {4}, 0, 2},
    {"trenchBroomAlongYFromOutside", {5, 1}, {{0, -10, 0}, 0, {0, 1, 0}, infinity}, {4}, 0, 4},
    {"trenchBroomAlongXFromOutside", {5, 1}, {{-10, 0, 0}, 0, {1, 0, 0}, infinity}, {4}, 0, 4},
    {"trenchBroomAlongMinusZ", {5, 1}, {{0, -5, 5}, 0, {0, 0, -1}, infinity}, {4}, 0, 2},
    // Opticks, intersect_analytic_test (2017): float32 gave -90.0002 and 90.0002 for the second and third.
    {"opticksAlongX", {100, 10}, {{-220, 0, 0}, 0, {1, 0, 0}, infinity}, {110, 130, 310, 330}, 0, 4},
    // OpenMC, pull request 2589 (2023): of a spindle the inner sheet was hit too. It spans |z| < 1, rho < 1/2
    // here.
    {"openMcAlongTheEquatorOfALens", {0.75F, 1.25F}, {{5, 0, 0}, 0, {-1, 0, 0}, infinity}, {3, 7}, 0, 2},
    {"openMcFromInsideTheLens", {0.75F, 1.25F}, {{0.25F, 0, 0}, 0, {1, 0, 0}, infinity}, {1.75}, 0, 1},
    {"openMcThroughTheSideOfTheLens", {0.75F, 1.25F}, {{5, 0.25F, 0.5F}, 0, {-1, 0, 0}, infinity}, {}, 0, 2},
    // OpenMC, pull request 2053 (2022): from a surface point of a wide torus the root 0 came out small and
    // positive.
    {"openMcFromASurfacePoint", {139, 3}, {{142, 0, 0}, 0, {-1, 0, 0.25F}, infinity}},
    {"openMcFromASurfacePointOfAWiderTorus", {1000, 3}, {{0, -1003, 0}, 0, {0.25F, 1, 0}, infinity}},
};

const StressRay ownFaults[] = {
    // Found by random rays in earlier versions of this library.
    {"throughAHornsTipFromAMillionR",
     {1, 1},
     {{-0x1.e293a6p+19F, -0x1.018c9cp+20F, -0x1.975c5ap+19F},
      0,
      {0x1.d72p-1F, 0x1.f6ep-1F, 0x1.8db1ap-1F},
      infinity}},
    // Past the dimple, where two extrema have just merged: the place where G is merely flat was taken for a
    // maximum.
    {"pastADimpleWhereExtremaHaveMerged",
     {1, 1.5F},
     {{-0x1.1fcddep+2F, -0x1.a65a08p+3F, 0x1.61e64ep+2F},
      0x1.d4deb8p+3F,
      {0x1.20cedcp-2F, 0x1.b5edap-1F, -0x1.bd04b8p-2F},
      0x1.fa41cp+3F}},
    // Through a spindle's axis: the edge of G there has no curvature, and the parabola found none but
    // rounding.
    {"throughASpindlesAxisBelowTheTip",
     {1, 1.5F},
     {{-0.0F, -0x1.1422bcp+20F, 0x1.e11416p+19F}, 0, {0, 0x1.8210eap-1F, -0x1.504c88p-1F}, infinity}},
    {"aPairNextToAHornsTip",
     {1, 1},
     {{-0x1.dc4af2p-6F, 0x1.5d18dep+0F, 0x1.8ea8f2p+0F},
      0,
      {-0x1.5b1dcp-6F, -0x1.297a62p-1F, -0x1.a092b6p-1F},
      infinity},
     {},
     0,
     4},
};

INSTANTIATE_TEST_SUITE_P(VecGeom, StressRays, testing::ValuesIn(vecGeom),
                         [](const auto& row) { return std::string(row.param.name); });
INSTANTIATE_TEST_SUITE_P(Others, StressRays, testing::ValuesIn(others),
                         [](const auto& row) { return std::string(row.param.name); });
INSTANTIATE_TEST_SUITE_P(OwnFaults, StressRays, testing::ValuesIn(ownFaults),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace raytorus
