// SPDX-License-Identifier: MIT
// What a device's arithmetic is like is asked of the device itself.
#include "trace/self_check.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/device_fixture.hpp"

namespace raytorus {
namespace {

using SelfCheck = test::DeviceTest;

TEST_F(SelfCheck, TheExactTierHasWhatItRestsOn) {
    EXPECT_TRUE(trace::selfCheck(test::device()).exact);
}

// lavapipe's and SwiftShader's round twice: whoever believed otherwise would lose every product's rounding.
TEST_F(SelfCheck, FmaIsNotWhatProcessorsHave) {
    const bool fused = trace::selfCheck(test::device()).fusedFma;
    if (test::device().info().type == "CPU") {
        EXPECT_FALSE(fused);
    }
    EXPECT_EQ(trace::selfCheck(test::device()).fusedFma, fused) << "asked once more";
}

// SwiftShader takes them for 0, lavapipe does not.
TEST_F(SelfCheck, DenormalsAreWhatTheDriverIsKnownFor) {
    const std::string name = test::device().info().name;
    const bool kept = trace::selfCheck(test::device()).denormals;
    if (name.find("SwiftShader") != std::string::npos) {
        EXPECT_FALSE(kept);
    } else if (name.find("llvmpipe") != std::string::npos) {
        EXPECT_TRUE(kept);
    }
}

}  // namespace
}  // namespace raytorus
