// SPDX-License-Identifier: MIT
// The difference picture: which colour stands for what.
#include "compare/difference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "image/srgb.hpp"
#include "support/expect_error.hpp"

namespace raytorus::compare {
namespace {

using Shown = std::array<int, 3>;  // as in the PNG

// The colour of one pixel with these values in the channels R and Z.
Shown shown(std::array<float, 2> expectedValues, std::array<float, 2> actualValues,
            const CompareRules& rules) {
    image::Image expected(2, 2, {"R", "Z"});
    image::Image actual(2, 2, {"Z", "R"});  // the order is another one on purpose
    std::ranges::copy(expectedValues, expected.pixel(1, 0).begin());
    std::ranges::copy(std::array{actualValues[1], actualValues[0]}, actual.pixel(1, 0).begin());
    const image::Image picture = differenceImage(expected, actual, rules);
    EXPECT_EQ(picture.channelNames, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(picture.pixel(0, 0)[2] + picture.pixel(0, 1)[2] + picture.pixel(1, 1)[2],
              0.0f);  // equal: black
    const std::span<const float> colour = picture.pixel(1, 0);
    return {image::encodeSrgb(colour[0]), image::encodeSrgb(colour[1]), image::encodeSrgb(colour[2])};
}

CompareRules within(double value) {
    CompareRules rules;
    rules.defaultRule.tolerance = value;
    return rules;
}

TEST(Difference, EqualIsBlack) {
    EXPECT_EQ(shown({1, 2}, {1, 2}, within(0.5)), (Shown{0, 0, 0}));
    EXPECT_EQ(shown({1, 0.0f}, {1, -0.0f}, within(0)), (Shown{0, 0, 0}));
}

TEST(Difference, WithinTheToleranceIsBlue) {
    EXPECT_EQ(shown({1, 2}, {1, 2.5f}, within(0.5)), (Shown{96, 160, 255}));      // the limit itself
    EXPECT_EQ(shown({1, 2}, {1.25f, 2}, within(0.5)), (Shown{60, 104, 192}));     // half of it
    EXPECT_EQ(shown({1, 2}, {1, 2.000001f}, within(0.5)), (Shown{24, 48, 128}));  // hardly any
}

TEST(Difference, OverTheToleranceGoesFromOrangeToWhiteInThreePowersOfTen) {
    EXPECT_EQ(shown({0, 0}, {0, 0.50001f}, within(0.5)), (Shown{255, 112, 0}));
    EXPECT_EQ(shown({0, 0}, {0, 15.8113883f}, within(0.5)), (Shown{255, 224, 64}));  // 10^1.5 limits
    EXPECT_EQ(shown({0, 0}, {500, 0}, within(0.5)), (Shown{255, 255, 255}));
    EXPECT_EQ(shown({0, 0}, {-1e30f, 0}, within(0.5)), (Shown{255, 255, 255}));
}

TEST(Difference, WithoutToleranceTheSmallestDifferenceIsOrange) {
    EXPECT_EQ(shown({0, 0}, {0, std::numeric_limits<float>::denorm_min()}, within(0)), (Shown{255, 112, 0}));
    EXPECT_EQ(shown({0, 0}, {0, 1e-3f}, within(0)), (Shown{255, 255, 255}));
}

TEST(Difference, TheWorstChannelIsMeasuredByItsOwnLimit) {
    CompareRules rules = within(0.5);
    rules.channelRules["Z"] = {100.0, 0.0};
    EXPECT_EQ(shown({0, 0}, {0, 100}, rules), (Shown{96, 160, 255}));
    EXPECT_EQ(shown({0, 0}, {0.6f, 100}, rules), (Shown{255, 118, 3}));  // R is over its limit
    rules.channelRules["Z"] = {0.0, 0.5};
    EXPECT_EQ(shown({0, 8}, {0, 12}, rules), (Shown{96, 160, 255}));
}

TEST(Difference, NonFiniteIsMagentaWhereverItIs) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(shown({bad, 0}, {0, 0}, within(1)), (Shown{255, 0, 255}));
        EXPECT_EQ(shown({0, 0}, {0, bad}, within(1)), (Shown{255, 0, 255}));
        EXPECT_EQ(shown({0, bad}, {900, bad}, within(1)), (Shown{255, 0, 255}));
    }
}

TEST(Difference, OfImagesOfOtherShapeThereIsNone) {
    const auto refuse = [](const image::Image& actual) {
        test::expectError([&] { std::ignore = differenceImage(image::Image(2, 2, {"R"}), actual, {}); },
                          ExitCode::SizeDiffers, {"difference"});
    };
    refuse(image::Image(2, 3, {"R"}));
    refuse(image::Image(2, 2, {"G"}));
}

}  // namespace
}  // namespace raytorus::compare
