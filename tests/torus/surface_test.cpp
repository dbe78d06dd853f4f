// SPDX-License-Identifier: MIT
// Normal, uv, position, tangents, distance and implicit function, through the real SPIR-V, against the
// reference.
#include <gtest/gtest.h>

#include "support/device_fixture.hpp"
#include "support/surface_checks.hpp"

namespace raytorus::test {
namespace {

std::vector<SurfaceAnswer> ask(const std::vector<SurfacePoint>& points) {
    return SurfaceProbe(device()).ask(points);
}

using Surface = DeviceTest;

TEST_F(Surface, NormalsAreUnitAndOutward) {
    EXPECT_EQ(normalFault(ask), "");
}

TEST_F(Surface, NormalsAreUnitWhereNoDirectionIsDistinguished) {
    EXPECT_EQ(undistinguishedNormalFault(ask), "");
}

TEST_F(Surface, UvIsRight) {
    EXPECT_EQ(uvFault(ask), "");
}

TEST_F(Surface, UvAtTheSeamsIsInRange) {
    EXPECT_EQ(seamFault(ask), "");
}

TEST_F(Surface, PositionsFollowTheEquation) {
    EXPECT_EQ(positionFault(ask), "");
}

TEST_F(Surface, TangentsAreTheDerivatives) {
    EXPECT_EQ(tangentFault(ask), "");
}

TEST_F(Surface, DistanceAndImplicitAreRightEverywhere) {
    EXPECT_EQ(distanceFault(ask), "");
}

}  // namespace
}  // namespace raytorus::test
