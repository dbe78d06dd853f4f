// SPDX-License-Identifier: MIT
// A comparison in words: the table for people, the JSON for programs.
#include "compare/comparison_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/special_floats.hpp"

namespace raytorus::compare {
namespace {

TEST(CompareText, ATableWithAlignedColumns) {
    image::Image expected(2, 1, {"R", "normal.x"});
    image::Image actual = expected;
    actual.pixels = {0.0f, 0.5f, 0.0f, 0.0f};
    CompareRules rules;
    rules.defaultRule.tolerance = 0.25;
    EXPECT_EQ(
        numbersTable(compare(expected, actual, rules)),
        "channel   tolerance  max diff      at  expected  actual  of limit      at  mean diff  rms diff  "
        "over  "
        "other bits\n"
        "R              0.25         0       -         -       -         0       -          0         0     "
        "0  "
        "         0\n"
        "normal.x       0.25       0.5  (0, 0)         0     0.5         2  (0, 0)       0.25    0.3536     "
        "1  "
        "         1\n"
        "2 x 1 pixels: 1 over the tolerance (0 allowed), at most 1 in a 5 x 5 window; 1 value has other "
        "bits\n");
}

TEST(CompareText, TheTableNamesEveryLimitOfAChannel) {
    const image::Image same(1, 1, {"R"});
    const auto limits = [&](const CompareRule& rule) {
        CompareRules rules;
        rules.defaultRule = rule;
        return numberRows(compare(same, same, rules)).at(1).at(1);
    };
    EXPECT_EQ(limits({}), "0");
    EXPECT_EQ(limits({0.25}), "0.25");
    EXPECT_EQ(limits({0.0, 0.0, 4}), "4 ulp");
    EXPECT_EQ(limits({0.25, 0.125, 4}), "0.25 or 0.125 rel or 4 ulp");
}

TEST(CompareText, JsonHoldsTheNumbers) {
    const image::Image expected(4, 3, {"R", "G", "B"});
    image::Image actual = expected;
    actual.pixel(3, 1)[1] += 0.25f;
    CompareRules rules;
    rules.defaultRule.tolerance = 0.125;
    rules.allowedPixels = 7;
    rules.windowLimit = 2;
    const auto json = nlohmann::json::parse(jsonText(compare(expected, actual, rules)));
    EXPECT_EQ(json["verdict"], "agree");
    EXPECT_EQ(json["passed"], true);
    EXPECT_EQ(json["exitCode"], 0);
    EXPECT_EQ(json["overLimitPixels"], 1);
    EXPECT_EQ(json["allowedPixels"], 7);
    EXPECT_EQ(json["windowLimit"], 2);
    EXPECT_EQ(json["channels"][1]["name"], "G");
    EXPECT_EQ(json["channels"][1]["maxPixel"], (nlohmann::json{3, 1}));
    EXPECT_EQ(json["channels"][1]["overLimit"], 1);
    EXPECT_EQ(json["channels"][0]["overLimit"], 0);
}

TEST(CompareText, JsonStaysJsonForNonFiniteValuesAndOddNames) {
    image::Image odd(1, 1, {"\xff\"<"});
    odd.pixels[0] = -infinity;
    const auto json = nlohmann::json::parse(jsonText(compare(odd, odd, {})));
    EXPECT_EQ(json["verdict"], "non-finite");
    EXPECT_EQ(json["exitCode"], 12);
    EXPECT_EQ(json["nonFinite"]["expected"]["value"], "-Inf");
    EXPECT_EQ(json["nonFinite"]["actual"]["count"], 1);
}

TEST(CompareText, ValuesAreShortAndComeBack) {
    EXPECT_EQ(valueText(0.1f), "0.1");
    EXPECT_EQ(valueText(-0.0f), "-0");
    EXPECT_EQ(valueText(nan), "NaN");
    EXPECT_EQ(valueText(-nan), "NaN");
    EXPECT_EQ(valueText(infinity), "+Inf");
    EXPECT_EQ(valueText(-infinity), "-Inf");
    EXPECT_EQ(std::stof(valueText(std::nextafter(0.1f, 1.0f))), std::nextafter(0.1f, 1.0f));
}

}  // namespace
}  // namespace raytorus::compare
