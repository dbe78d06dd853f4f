// SPDX-License-Identifier: MIT
// Whether a device's fma() rounds once is asked of the device itself.
#include "trace/fused_fma.hpp"

#include <gtest/gtest.h>

#include "support/device_fixture.hpp"

namespace raytorus {
namespace {

using FusedFma = test::DeviceTest;

// lavapipe's and SwiftShader's round twice: whoever believed otherwise would lose every product's rounding.
TEST_F(FusedFma, IsNotWhatProcessorsHave) {
    const bool fused = trace::fusesFma(test::device());
    if (test::device().info().type == "CPU") {
        EXPECT_FALSE(fused);
    }
    EXPECT_EQ(trace::fusesFma(test::device()), fused) << "asked once more";
}

}  // namespace
}  // namespace raytorus
