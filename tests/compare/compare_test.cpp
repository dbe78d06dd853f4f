// SPDX-License-Identifier: MIT
// Comparing images: the gates in their order, each limit from both sides, and the numbers.
#include "compare/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/comparison_text.hpp"
#include "support/expect_error.hpp"
#include "support/special_floats.hpp"

namespace raytorus::compare {
namespace {

using test::expectError;

image::Image image(int width, int height, std::vector<std::string> names = {"R", "G", "B"}) {
    image::Image made(width, height, std::move(names));
    for (std::size_t i = 0; i < made.pixels.size(); ++i) {
        made.pixels[i] = 0.25f + static_cast<float>(i) / 4096.0f;  // so that sums are exact
    }
    return made;
}

CompareRules tolerance(double value, std::int64_t allowedPixels = 0) {
    CompareRules rules;
    rules.defaultRule.tolerance = value;
    rules.allowedPixels = allowedPixels;
    return rules;
}

TEST(Compare, IdenticalImagesAreIdentical) {
    const Comparison result = compare(image(4, 3), image(4, 3), {});
    EXPECT_EQ(result.verdict, Verdict::Identical);
    EXPECT_EQ(result.exitCode(), ExitCode::Ok);
    EXPECT_EQ(result.sentence, "The images are identical.");
    EXPECT_EQ(result.bitDifferentValues, 0);
    EXPECT_EQ(result.channels.size(), 3u);
    EXPECT_NE(numbersTable(result).find("rms diff"), std::string::npos);
}

TEST(Compare, OtherSizeOrChannelsAreNotCompared) {
    const image::Image expected = image(4, 3);
    for (const image::Image& other :
         {image(3, 4), image(4, 4), image(5, 3), image(4, 3, {"R", "G"}), image(4, 3, {"R", "G", "Z"}),
          image(4, 3, {"R", "G", "B", "A"}), image::Image()}) {
        for (const auto& [first, second] : {std::pair(&expected, &other), std::pair(&other, &expected)}) {
            const Comparison result = compare(*first, *second, tolerance(100.0, 1000));
            EXPECT_EQ(result.verdict, Verdict::SizeDiffers);
            EXPECT_EQ(result.exitCode(), ExitCode::SizeDiffers);
            EXPECT_TRUE(result.channels.empty());
            EXPECT_EQ(numbersTable(result), "");
        }
    }
    EXPECT_EQ(compare(expected, image(4, 4, {"R", "Z"}), {}).sentence,
              "The images cannot be compared: the expected one has 4 x 3 pixels with the channels R, G, B, "
              "the actual one 4 x 4 pixels with the channels R, Z.");
    EXPECT_EQ(
        compare(expected, image(4, 4), {}).sentence,
        "The images cannot be compared: the expected one has 4 x 3 pixels, the actual one 4 x 4 pixels.");
    EXPECT_EQ(compare(image::Image(), image::Image(), {}).verdict,
              Verdict::SizeDiffers);  // nothing is never equal to nothing
}

TEST(Compare, ChannelsAreMatchedByName) {
    image::Image expected = image(2, 1, {"R", "Z"});
    image::Image actual = image(2, 1, {"Z", "R"});
    expected.pixels = {1, 2, 3, 4};
    actual.pixels = {2, 1, 4, 3};
    EXPECT_EQ(compare(expected, actual, {}).verdict, Verdict::Identical);
    actual.pixels = {1, 2, 3, 4};
    EXPECT_EQ(compare(expected, actual, {}).overLimitPixels, 2);
}

TEST(Compare, NonFiniteInEitherImageAndAnyChannelIsRefusedUnderAnyTolerance) {
    CompareRules generous = tolerance(1e300, 1'000'000);
    generous.defaultRule.relativeTolerance = 1e300;
    for (const float bad : {nan, -nan, infinity, -infinity}) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            for (const bool inExpected : {true, false}) {
                image::Image expected = image(4, 3);
                image::Image actual = image(4, 3);
                image::Image& damaged = inExpected ? expected : actual;
                damaged.pixel(1, 2)[channel] = bad;
                damaged.pixel(2, 2)[0] = bad;
                const Comparison result = compare(expected, actual, generous);
                EXPECT_EQ(result.verdict, Verdict::NonFinite);
                EXPECT_EQ(result.exitCode(), ExitCode::NonFinite);
                const NonFiniteValues& found = inExpected ? result.expectedNonFinite : result.actualNonFinite;
                const NonFiniteValues& clean = inExpected ? result.actualNonFinite : result.expectedNonFinite;
                EXPECT_EQ(found.count, 2);
                EXPECT_EQ(found.channel, expected.channelNames[channel]);
                EXPECT_EQ(found.pixel, (Pixel{1, 2}));
                EXPECT_EQ(valueText(found.value), valueText(bad));
                EXPECT_EQ(clean.count, 0);
            }
        }
    }
}

TEST(Compare, TheSameNonFiniteValuesInBothImagesAreRefusedToo) {
    for (const float bad : {nan, infinity, -infinity}) {
        image::Image both = image(2, 2);
        std::ranges::fill(both.pixels, bad);
        const Comparison result = compare(both, both, tolerance(1.0, 4));
        EXPECT_EQ(result.verdict, Verdict::NonFinite);
        EXPECT_EQ(result.expectedNonFinite.count, 12);
        EXPECT_EQ(result.actualNonFinite.count, 12);
        EXPECT_EQ(result.sentence,
                  "The images cannot be compared: the expected image has 12 values that are not finite, "
                  "first " +
                      valueText(bad) +
                      " in channel R at pixel (0, 0), and the actual image has "
                      "12 values that are not finite, first " +
                      valueText(bad) + " in channel R at pixel (0, 0).");
    }
}

TEST(Compare, ADifferenceOfTheToleranceItselfAgreesAndTheNextFloatDoesNot) {
    image::Image expected(2, 1, {"R"});
    image::Image actual(2, 1, {"R"});
    for (const float sign : {1.0f, -1.0f}) {
        expected.pixels = {1.0f, 1.0f};
        actual.pixels = {1.0f, 1.0f + sign * 0.125f};
        EXPECT_EQ(compare(expected, actual, tolerance(0.125)).verdict, Verdict::Agree);
        actual.pixels[1] = std::nextafter(actual.pixels[1], sign * infinity);
        EXPECT_EQ(compare(expected, actual, tolerance(0.125)).verdict, Verdict::Differ);
    }
}

TEST(Compare, TheRelativeToleranceIsOfTheExpectedValueAndTheLargerLimitCounts) {
    const auto verdict = [](float expectedValue, float actualValue, CompareRule rule) {
        image::Image expected(1, 1, {"R"});
        image::Image actual(1, 1, {"R"});
        expected.pixels[0] = expectedValue;
        actual.pixels[0] = actualValue;
        CompareRules rules;
        rules.defaultRule = rule;
        return compare(expected, actual, rules).verdict;
    };
    EXPECT_EQ(verdict(-8.0f, -10.0f, {0.0, 0.25}), Verdict::Agree);
    EXPECT_EQ(verdict(-8.0f, -10.000001f, {0.0, 0.25}), Verdict::Differ);
    EXPECT_EQ(verdict(8.0f, 10.0f, {0.0, 0.2}), Verdict::Differ);  // 2 is 0.2 of the actual value
    EXPECT_EQ(verdict(8.0f, 10.0f, {1.0, 0.2}), Verdict::Differ);  // the limits do not add up
    EXPECT_EQ(verdict(8.0f, 10.0f, {2.0, 0.1}), Verdict::Agree);
    EXPECT_EQ(verdict(0.0f, 1e-30f, {0.0, 0.5}), Verdict::Differ);  // nothing is relative to 0
}

TEST(Compare, AnUlpIsTheStepAwayFromZero) {
    using Limits = std::numeric_limits<float>;
    for (const float value : {1.0f, 1.5f, 2.0f, 3.1415927f, 1e-20f, 1e30f, 0.0f, Limits::denorm_min(),
                              Limits::min(), std::nextafter(Limits::min(), 0.0f)}) {
        const double step = static_cast<double>(std::nextafter(value, infinity)) - static_cast<double>(value);
        EXPECT_EQ(ulpOf(value), step) << value;
        EXPECT_EQ(ulpOf(-value), step) << value;
    }
    EXPECT_EQ(ulpOf(Limits::max()), std::ldexp(1.0, 104));

    CompareRules rules;
    rules.defaultRule.ulps = 2;
    image::Image expected(1, 1, {"R"});
    image::Image actual(1, 1, {"R"});
    for (const float value : {1.0f, -3.0f, 0.0f, 1e-40f}) {
        expected.pixels[0] = value;
        actual.pixels[0] = value;
        for (int step = 1; step <= 3; ++step) {
            actual.pixels[0] = std::nextafter(actual.pixels[0], value < 0.0f ? -infinity : infinity);
            EXPECT_EQ(compare(expected, actual, rules).passed(), step <= 2) << value << " " << step;
        }
    }
    EXPECT_EQ(compare(expected, actual, rules).channels[0].maxRatio, 1.5);
    rules.defaultRule.tolerance = 1.0;  // the larger of the two counts
    EXPECT_TRUE(compare(expected, actual, rules).passed());
}

TEST(Compare, OtherSampleTypesAreNotCompared) {
    image::Image stored = image(4, 3);
    for (const image::SampleType type :
         {image::SampleType::Float16, image::SampleType::Unsigned8, image::SampleType::Unsigned16}) {
        stored.sampleType = type;
        EXPECT_EQ(compare(stored, image(4, 3), {}).verdict, Verdict::SizeDiffers);
        EXPECT_EQ(compare(image(4, 3), stored, {}).exitCode(), ExitCode::SizeDiffers);
        EXPECT_EQ(compare(stored, stored, {}).verdict, Verdict::Identical);
    }
    stored.sampleType = image::SampleType::Unsigned8;
    EXPECT_EQ(compare(stored, image(4, 3), {}).sentence,
              "The images cannot be compared: the expected one holds 8 bit integers, the actual one 32 bit "
              "floats.");
}

TEST(Compare, ARuleOfAChannelReplacesTheDefault) {
    image::Image actual = image(4, 3);
    actual.pixel(3, 1)[1] += 0.25f;
    CompareRules rules = tolerance(0.5);
    EXPECT_EQ(compare(image(4, 3), actual, rules).verdict, Verdict::Agree);
    rules.channelRules["G"] = {0.125, 0.0};
    EXPECT_EQ(compare(image(4, 3), actual, rules).verdict, Verdict::Differ);
    rules = tolerance(0.0);
    rules.channelRules["G"] = {0.5, 0.0};
    EXPECT_EQ(compare(image(4, 3), actual, rules).verdict, Verdict::Agree);
    actual.pixel(0, 0)[0] += 0.25f;
    EXPECT_EQ(compare(image(4, 3), actual, rules).verdict, Verdict::Differ);
}

TEST(Compare, AllowedPixelsAreCountedPerPixelAndTheCountItselfIsAllowed) {
    image::Image actual = image(8, 8);
    for (int i = 0; i < 3; ++i) {
        actual.pixel(2 * i, i)[0] += 1.0f;
        actual.pixel(2 * i, i)[2] += 1.0f;  // the same pixel again
    }
    const Comparison allowed = compare(image(8, 8), actual, tolerance(0.5, 3));
    EXPECT_EQ(allowed.verdict, Verdict::Agree);
    EXPECT_EQ(allowed.overLimitPixels, 3);
    EXPECT_EQ(allowed.channels[0].overLimit, 3);
    EXPECT_EQ(allowed.channels[1].overLimit, 0);
    EXPECT_EQ(allowed.channels[2].overLimit, 3);
    const Comparison tooMany = compare(image(8, 8), actual, tolerance(0.5, 2));
    EXPECT_EQ(tooMany.verdict, Verdict::Differ);
    EXPECT_EQ(tooMany.exitCode(), ExitCode::ComparisonFailed);
    EXPECT_EQ(tooMany.sentence,
              "The images differ: 3 pixels of 64 over the tolerance, 2 allowed, and the largest "
              "difference is 1 in channel R at pixel (0, 0).");
}

TEST(Compare, TheNumbersOfAChannel) {
    image::Image expected(2, 2, {"R"});
    image::Image actual(2, 2, {"R"});
    expected.pixels = {1.0f, 2.0f, 3.0f, 0.0f};
    actual.pixels = {1.5f, 2.0f, 1.0f, -0.0f};
    const Comparison result = compare(expected, actual, tolerance(1.0));
    const ChannelComparison& red = result.channels.at(0);
    EXPECT_EQ(red.maxDifference, 2.0);
    EXPECT_EQ(red.maxPixel, (Pixel{0, 1}));
    EXPECT_EQ(red.expectedAtMax, 3.0f);
    EXPECT_EQ(red.actualAtMax, 1.0f);
    EXPECT_EQ(red.meanDifference, 2.5 / 4.0);
    EXPECT_EQ(red.rmsDifference, std::sqrt(4.25 / 4.0));
    EXPECT_EQ(red.overLimit, 1);
    EXPECT_EQ(red.bitDifferent, 3);
    EXPECT_EQ(result.bitDifferentValues, 3);
}

TEST(Compare, ZerosOfOtherSignAgreeButAreNotIdentical) {
    image::Image expected(1, 1, {"R"});
    image::Image actual(1, 1, {"R"});
    actual.pixels[0] = -0.0f;
    const Comparison result = compare(expected, actual, {});
    EXPECT_EQ(result.verdict, Verdict::Agree);
    EXPECT_EQ(result.bitDifferentValues, 1);
}

TEST(Compare, TheSmallestDifferenceFailsWithoutTolerance) {
    image::Image expected(3, 3, {"R"});
    image::Image actual(3, 3, {"R"});
    actual.pixel(2, 2)[0] = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(compare(expected, actual, {}).verdict, Verdict::Differ);
    std::ranges::fill(expected.pixels, std::numeric_limits<float>::max());
    std::ranges::fill(actual.pixels, std::numeric_limits<float>::lowest());
    const Comparison result = compare(expected, actual, {});
    EXPECT_EQ(result.channels[0].maxDifference, 2.0 * static_cast<double>(std::numeric_limits<float>::max()));
    EXPECT_TRUE(std::isfinite(result.channels[0].rmsDifference));
}

image::Image withDots(int width, int height, std::initializer_list<Pixel> dots) {
    image::Image dotted = image(width, height);
    for (const Pixel dot : dots) {
        dotted.pixel(dot.x, dot.y)[0] += 1.0f;
    }
    return dotted;
}

TEST(Compare, TheWindowTellsAClusterFromScatteredPixels) {
    const image::Image expected = image(20, 20);
    CompareRules rules = tolerance(0.5, 100);
    rules.windowLimit = 3;
    const Comparison scattered =
        compare(expected, withDots(20, 20, {{0, 0}, {19, 0}, {0, 19}, {19, 19}}), rules);
    EXPECT_EQ(scattered.verdict, Verdict::Agree);
    EXPECT_EQ(scattered.worstWindowCount, 1);
    // The first four fit into 5 x 5 pixels, the last is just outside.
    const image::Image clustered = withDots(20, 20, {{10, 8}, {14, 8}, {12, 12}, {11, 9}, {15, 13}});
    const Comparison cluster = compare(expected, clustered, rules);
    EXPECT_EQ(cluster.verdict, Verdict::Differ);
    EXPECT_EQ(cluster.worstWindowCount, 4);
    EXPECT_EQ(cluster.worstWindow, (Pixel{10, 8}));
    EXPECT_EQ(cluster.sentence,
              "The images differ: 4 pixels over the tolerance in the 5 x 5 window at (10, 8), 3 allowed,"
              " and the largest difference is 1 in channel R at pixel (10, 8).");
    rules.windowLimit = 4;
    EXPECT_EQ(compare(expected, clustered, rules).verdict, Verdict::Agree);
    rules.windowLimit.reset();
    EXPECT_EQ(compare(expected, clustered, rules).verdict, Verdict::Agree);
}

TEST(Compare, TheWindowCountIsThatOfTheSimpleDefinition) {
    for (const auto& [width, height, side] :
         {std::tuple(17, 9, 5), std::tuple(9, 17, 4), std::tuple(3, 12, 5), std::tuple(6, 6, 1),
          std::tuple(1, 1, 5)}) {
        image::Image actual = image(width, height);
        std::uint32_t state = 12345;
        for (float& value : actual.pixels) {
            state = state * 1664525u + 1013904223u;
            value += (state >> 28) == 0 ? 1.0f : 0.0f;
        }
        CompareRules rules = tolerance(0.5);
        rules.windowSize = side;
        std::int64_t most = 0;
        for (int top = 0; top < height; ++top) {
            for (int left = 0; left < width; ++left) {
                std::int64_t count = 0;
                for (int y = top; y < std::min(top + side, height); ++y) {
                    for (int x = left; x < std::min(left + side, width); ++x) {
                        count +=
                            std::ranges::any_of(actual.pixel(x, y), [](float v) { return v > 1.0f; }) ? 1 : 0;
                    }
                }
                most = std::max(most, count);
            }
        }
        EXPECT_EQ(compare(image(width, height), actual, rules).worstWindowCount, most)
            << width << " " << height;
    }
}

TEST(Compare, RulesThatMakeNoSenseAreRefused) {
    const auto refuse = [](const CompareRules& rules, const std::string& word) {
        expectError([&] { std::ignore = compare(image(2, 2), image(2, 2), rules); }, ExitCode::Usage, {word});
    };
    refuse(tolerance(-1e-9), "tolerance");
    refuse(tolerance(std::numeric_limits<double>::quiet_NaN()), "tolerance");
    refuse(tolerance(std::numeric_limits<double>::infinity()), "tolerance");
    refuse(tolerance(0.0, -1), "allowed");
    CompareRules rules;
    rules.defaultRule.relativeTolerance = -1.0;
    refuse(rules, "relative");
    rules = {};
    rules.defaultRule.ulps = -1;
    refuse(rules, "ulps");
    rules = {};
    rules.windowSize = 0;
    refuse(rules, "window");
    rules = {};
    rules.windowLimit = -1;
    refuse(rules, "window");
    rules = {};
    rules.channelRules["Z"] = {1.0, 0.0};
    refuse(rules, "channel Z, but the images have R, G, B");
    rules = {};
    rules.channelRules["G"] = {-1.0, 0.0};
    refuse(rules, "channel G");
}

}  // namespace
}  // namespace raytorus::compare
