// SPDX-License-Identifier: MIT
// The polynomial in the place of a third of an arc cosine is as right as its comment says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace raytorus::test {

float thirdCosineAsCxx(float s);

}  // namespace raytorus::test

namespace raytorus {
namespace {

TEST(ThirdCosine, IsRightToTwoRoundings) {
    constexpr int steps = 100000;
    double largest = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(steps);
        const double exact = std::cos(2.0 / 3.0 * std::acos(static_cast<double>(s)));
        largest = std::max(largest, std::abs(static_cast<double>(test::thirdCosineAsCxx(s)) - exact));
    }
    EXPECT_LE(largest, 1.1e-7);
}

TEST(ThirdCosine, IsExactAtBothEnds) {
    EXPECT_EQ(test::thirdCosineAsCxx(0.0F), 0.5F);
    EXPECT_EQ(test::thirdCosineAsCxx(1.0F), 1.0F);
}

// 4 c^3 - 3 c = x
TEST(ThirdCosine, SolvesTheCubic) {
    for (const double x : {-0.99, -0.5, 0.0, 0.25, 0.9, 1.0}) {
        const double c =
            static_cast<double>(test::thirdCosineAsCxx(static_cast<float>(std::sqrt(0.5 + 0.5 * x))));
        EXPECT_NEAR((4.0 * c * c - 3.0) * c, x, 2e-6) << x;
    }
}

}  // namespace
}  // namespace raytorus
