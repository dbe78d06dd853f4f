// SPDX-License-Identifier: MIT
// Comparing with a truth: what it is sure of, what each pixel may be off, and what may flip.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/compare.hpp"
#include "compare/comparison_text.hpp"
#include "compare/difference.hpp"
#include "image/channels.hpp"
#include "image/srgb.hpp"
#include "support/expect_error.hpp"

namespace raytorus::compare {
namespace {

using test::expectError;

using image::ChannelKind;

const std::vector<std::string> valueNames =
    image::channelsOf({ChannelKind::Color, ChannelKind::Alpha, ChannelKind::Geometry});
const std::vector<std::string> truthNames = image::channelsOf({ChannelKind::Margin, ChannelKind::Tolerance});

float& at(image::Image& image, const std::string& channel, Pixel pixel = {2, 1}) {
    return image.at(pixel.x, pixel.y, channel);
}

image::Image values() {
    image::Image image(4, 3, valueNames);
    std::ranges::fill(image.pixels, 0.5f);
    return image;
}

// Sure of every pixel, and lets every value be off by 1/8.
image::Image truth() {
    std::vector<std::string> names = truthNames;  // they need not come last
    names.insert(names.begin() + 1, valueNames.begin(), valueNames.end());
    image::Image image(4, 3, names);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (const std::string& name : names) {
                at(image, name, {x, y}) = name.starts_with("margin")      ? 1.0f
                                          : name.starts_with("tolerance") ? 0.125f
                                                                          : 0.5f;
            }
        }
    }
    return image;
}

Comparison judged(const std::string& channel, float value, const CompareRules& rules = {}) {
    image::Image actual = values();
    at(actual, channel) = value;
    return compare(truth(), actual, rules);
}

TEST(CompareTruth, TheSameValuesAreIdenticalWithoutTheChannelsOfTheTruth) {
    const Comparison result = compare(truth(), values(), {});
    EXPECT_EQ(result.verdict, Verdict::Identical) << result.sentence;
    EXPECT_TRUE(result.againstTruth);
    ASSERT_EQ(result.channels.size(), valueNames.size());
    EXPECT_EQ(result.channels[0].name, "R");
    EXPECT_EQ(result.margins.size(), 3u);
    EXPECT_EQ(compare(truth(), truth(), {}).verdict, Verdict::Identical);
}

TEST(CompareTruth, ChannelsOfTheActualImageMustBeThoseOfTheValues) {
    image::Image fewer(4, 3, {valueNames.begin(), valueNames.end() - 1});
    EXPECT_EQ(compare(truth(), fewer, {}).verdict, Verdict::SizeDiffers);
    EXPECT_EQ(
        compare(image::Image(1, 1, {"id", "margin"}), image::Image(1, 1, {"t"}), {}).sentence,
        "The images cannot be compared: the expected one has 1 x 1 pixels with the channels id, the actual "
        "one 1 x 1 pixels with the channels t.");
    std::vector<std::string> names = valueNames;
    names.push_back("margin");
    EXPECT_EQ(compare(truth(), image::Image(4, 3, names), {}).verdict, Verdict::SizeDiffers);
    names.back() = "other";
    EXPECT_EQ(compare(truth(), image::Image(4, 3, names), {}).verdict, Verdict::SizeDiffers);
    EXPECT_EQ(compare(values(), truth(), {}).verdict,
              Verdict::SizeDiffers);  // a truth judges, it is not judged
}

TEST(CompareTruth, TwoTruthsAreComparedAsImages) {
    image::Image other = truth();
    at(other, "tolerance.t") = 0.25f;
    const Comparison result = compare(truth(), other, {});
    EXPECT_EQ(result.verdict, Verdict::Differ);
    EXPECT_FALSE(result.againstTruth);
    EXPECT_NE(result.sentence.find("tolerance.t"), std::string::npos) << result.sentence;
}

TEST(CompareTruth, EachChannelHasTheToleranceOfItsPixel) {
    for (const std::string& name : valueNames) {
        const bool exact = name == "A" || name == "count" || name == "id";
        for (const float sign : {-1.0f, 1.0f}) {
            EXPECT_EQ(judged(name, 0.5f + sign * 0.125f).passed(), !exact) << name;
            const Comparison over = judged(name, 0.5f + sign * 0.126f);
            EXPECT_EQ(over.verdict, Verdict::Differ) << name;
            EXPECT_EQ(over.overLimitPixels, 1) << name;
            EXPECT_EQ(over.inexactValues, exact ? 1 : 0) << name;
        }
    }
    // Another pixel's tolerance is its own.
    image::Image expected = truth();
    at(expected, "tolerance.t", {0, 0}) = 100.0f;
    image::Image actual = values();
    at(actual, "t", {0, 0}) = 50.0f;
    EXPECT_TRUE(compare(expected, actual, {}).passed());
    at(actual, "t", {1, 0}) = 50.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
}

TEST(CompareTruth, EachTruthChannelServesItsOwnGroup) {
    const auto channelsOf = [](const std::string& truthChannel, float changed, float off) {
        std::vector<std::string> served;
        for (const std::string& name : valueNames) {
            image::Image expected = truth();
            at(expected, truthChannel) = changed;
            image::Image actual = values();
            at(actual, name) += off;
            if (compare(expected, actual, {}).passed()) {
                served.push_back(name);
            }
        }
        return served;
    };
    using Names = std::vector<std::string>;
    const Names color = {"R", "G", "B"};
    const Names nearest = {"t",        "position.x", "position.y", "position.z", "normal.x",
                           "normal.y", "normal.z",   "uv.u",       "uv.v",       "id"};
    EXPECT_EQ(channelsOf("margin", 0.999f, 0.4f), nearest);
    EXPECT_EQ(channelsOf("margin.count", 0.999f, 0.4f), Names{"count"});
    EXPECT_EQ(channelsOf("margin.color", -1.0f, 0.4f), color);
    EXPECT_EQ(channelsOf("margin", 1.0f, 0.4f), Names{});
    EXPECT_EQ(channelsOf("tolerance.color", 0.5f, 0.4f), color);
    EXPECT_EQ(channelsOf("tolerance.t", 0.5f, 0.4f), Names{"t"});
    EXPECT_EQ(channelsOf("tolerance.position", 0.5f, 0.4f),
              (Names{"position.x", "position.y", "position.z"}));
    EXPECT_EQ(channelsOf("tolerance.normal", 0.5f, 0.4f), (Names{"normal.x", "normal.y", "normal.z"}));
    EXPECT_EQ(channelsOf("tolerance.uv", 0.5f, 0.4f), (Names{"uv.u", "uv.v"}));
}

TEST(CompareTruth, RulesCanOnlyLoosenWhatIsNotPromisedExactly) {
    CompareRules rules;
    rules.defaultRule.tolerance = 1.0;
    rules.allowedPixels = 12;
    EXPECT_EQ(judged("t", 1.5f, rules).verdict, Verdict::Agree);
    const Comparison id = judged("id", 0.75f, rules);
    EXPECT_EQ(id.verdict, Verdict::Differ);
    EXPECT_EQ(id.sentence,
              "The images differ: 1 value is not what the truth is sure of, the worst 0.75 instead of 0.5 in "
              "channel id at pixel (2, 1).");
    rules.channelRules["id"] = {1.0, 0.0};
    EXPECT_EQ(judged("id", 0.75f, rules).verdict, Verdict::Agree);
    rules.channelRules["margin"] = {1.0, 0.0};
    expectError([&] { std::ignore = judged("t", 0.5f, rules); }, ExitCode::Usage, {"channel margin"});
}

TEST(CompareTruth, UvGoesRoundACircle) {
    image::Image expected = truth();
    image::Image actual = values();
    for (const char* channel : {"uv.u", "uv.v"}) {
        at(expected, channel) = 0.0625f;
        at(actual, channel) = 1.0f;
    }
    const Comparison near = compare(expected, actual, {});
    EXPECT_TRUE(near.passed()) << near.sentence;
    EXPECT_EQ(near.channels[11].maxDifference, 0.0625);
    at(actual, "uv.v") = 0.9f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
    for (const float outside : {1.0625f, -0.9375f, 2.0625f}) {  // the same angle, and not on the circle
        at(actual, "uv.v") = outside;
        EXPECT_FALSE(compare(expected, actual, {}).passed()) << outside;
    }
    // Elsewhere 0 and 1 are as far apart as they are.
    at(actual, "uv.v") = 1.0f;
    at(expected, "t") = 0.0f;
    at(actual, "t") = 1.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
}

TEST(CompareTruth, FlipsAreCountedByPixelAndByGroup) {
    image::Image expected = truth();
    for (int x = 0; x < 4; ++x) {
        at(expected, "margin", {x, 0}) = 0.5f;
    }
    at(expected, "margin.color", {3, 0}) = 0.0f;
    at(expected, "margin.color", {3, 2}) = 0.0f;
    image::Image actual = values();
    at(actual, "t", {1, 0}) = 7.0f;
    at(actual, "id", {1, 0}) = 7.0f;  // the same pixel and group again
    at(actual, "id", {3, 0}) = 7.0f;
    at(actual, "R", {3, 0}) = 0.0f;     // another group
    at(actual, "t", {2, 0}) = 0.5625f;  // within the tolerance: no flip
    CompareRules rules;
    const Comparison result = compare(expected, actual, rules);
    EXPECT_EQ(result.verdict, Verdict::Agree);
    EXPECT_EQ(result.flippedPixels, 2);
    EXPECT_EQ(result.overLimitPixels, 0);
    const auto group = [&](const std::string& name) {
        return *std::ranges::find(result.margins, name, &MarginalPixels::margin);
    };
    EXPECT_EQ(group("margin").count, 4);
    EXPECT_EQ(group("margin").flips, 2);
    EXPECT_EQ(group("margin").firstFlip, (Pixel{1, 0}));
    EXPECT_EQ(group("margin.color").count, 2);
    EXPECT_EQ(group("margin.color").flips, 1);
    EXPECT_EQ(group("margin.count").count, 0);
    EXPECT_EQ(result.channels[4].judged, 8);  // t: without its marginal pixels
    EXPECT_EQ(result.channels[4].maxDifference, 0.0);
    EXPECT_EQ(result.channels[4].bitDifferent, 2);

    rules.allowedFlips = 2;
    EXPECT_EQ(compare(expected, actual, rules).verdict, Verdict::Agree);
    rules.allowedFlips = 1;
    const Comparison tooMany = compare(expected, actual, rules);
    EXPECT_EQ(tooMany.verdict, Verdict::Differ);
    EXPECT_EQ(tooMany.exitCode(), ExitCode::ComparisonFailed);
    EXPECT_EQ(
        tooMany.sentence,
        "The images differ: 2 marginal pixels flipped, 1 allowed, the first of margin at pixel (1, 0).");
}

TEST(CompareTruth, AMarginalPixelMayNotFlipInWhatItIsSureOf) {
    image::Image expected = truth();
    at(expected, "margin") = 0.0f;
    image::Image actual = values();
    at(actual, "count") = 3.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
    actual = values();
    at(actual, "B") = 0.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
    actual = values();
    at(actual, "A") = 0.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
}

TEST(CompareTruth, NonFiniteNeverPassesInAnyChannelOrMarginalPixel) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (const std::string& name : truth().channelNames) {
            image::Image expected = truth();
            at(expected, name) = bad;
            EXPECT_EQ(compare(expected, values(), {}).exitCode(), ExitCode::NonFinite) << name;
        }
        for (const std::string& name : valueNames) {
            image::Image expected = truth();
            at(expected, "margin") = at(expected, "margin.count") = at(expected, "margin.color") = 0.0f;
            image::Image actual = values();
            at(actual, name) = bad;
            const Comparison result = compare(expected, actual, {});
            EXPECT_EQ(result.exitCode(), ExitCode::NonFinite) << name;
            EXPECT_EQ(result.actualNonFinite.channel, name);
        }
    }
}

TEST(CompareTruth, WithoutAMarginNothingIsMarginalAndWithoutAToleranceNothingIsAllowed) {
    std::vector<std::string> names = valueNames;
    names.emplace_back("tolerance.t");
    image::Image expected(4, 3, names);
    image::Image actual(4, 3, valueNames);
    EXPECT_TRUE(compare(expected, actual, {}).passed());
    at(expected, "tolerance.t") = 1.0f;
    at(actual, "t") = 1.0f;
    EXPECT_TRUE(compare(expected, actual, {}).passed());
    at(expected, "tolerance.t") = -1.0f;
    EXPECT_FALSE(compare(expected, actual, {}).passed());
    at(actual, "t") = 0.0f;
    EXPECT_TRUE(compare(expected, actual, {}).passed());  // a negative tolerance allows what is equal
    at(actual, "normal.z") = std::numeric_limits<float>::denorm_min();
    EXPECT_FALSE(compare(expected, actual, {}).passed());
    EXPECT_TRUE(compare(expected, actual, {}).margins.empty());
}

TEST(CompareTruth, FlipsAreAllowedOnlyWhereATruthKnowsOfThem) {
    CompareRules rules;
    rules.allowedFlips = 0;
    expectError([&] { std::ignore = compare(values(), values(), rules); }, ExitCode::Usage, {"flip"});
    rules.allowedFlips = -1;
    expectError([&] { std::ignore = compare(truth(), values(), rules); }, ExitCode::Usage, {"flips", "-1"});
}

TEST(CompareTruth, TellsTheWorstOfItsToleranceAndWhere) {
    image::Image expected = truth();
    at(expected, "tolerance.t", {3, 2}) = 0.25f;
    image::Image actual = values();
    at(actual, "t", {3, 2}) = 0.625f;    // the largest difference, half of its tolerance
    at(actual, "t", {0, 1}) = 0.59375f;  // three quarters of it
    const Comparison result = compare(expected, actual, {});
    EXPECT_EQ(result.channels[4].maxDifference, 0.125);
    EXPECT_EQ(result.channels[4].maxPixel, (Pixel{3, 2}));
    EXPECT_EQ(result.channels[4].maxRatio, 0.75);
    EXPECT_EQ(result.channels[4].maxRatioPixel, (Pixel{0, 1}));
    EXPECT_EQ(result.sentence,
              "The images agree within the tolerance: the largest difference is 0.75 times the "
              "tolerance in channel t at pixel (0, 1).");
    const std::string table = numbersTable(result);
    for (const char* words :
         {"\nt           per pixel     0.125  (3, 2)", "\nid              exact ",
          "margin: 0 marginal, 0 flipped\n", "0 pixels flipped in any of them (all allowed)\n"}) {
        EXPECT_NE(table.find(words), std::string::npos) << words << " is not in\n" << table;
    }
}

TEST(CompareTruth, JsonHoldsMarginsAndRatios) {
    image::Image expected = truth();
    at(expected, "margin") = 0.0f;
    image::Image actual = values();
    at(actual, "id") = 9.0f;
    at(actual, "count") = 9.0f;
    CompareRules rules;
    rules.allowedFlips = 3;
    const auto json = nlohmann::json::parse(jsonText(compare(expected, actual, rules)));
    EXPECT_EQ(json["againstTruth"], true);
    EXPECT_EQ(json["flippedPixels"], 1);
    EXPECT_EQ(json["allowedFlips"], 3);
    EXPECT_EQ(json["inexactValues"], 1);
    EXPECT_EQ(json["channels"][13]["maxRatio"], "+Inf");  // count
    EXPECT_EQ(json["channels"][13]["exact"], true);
    EXPECT_EQ(json["channels"][4]["perPixel"], true);
    EXPECT_EQ(json["channels"][4]["judged"], 11);
    const auto& margins = json["margins"];
    ASSERT_EQ(margins.size(), 3u);
    const auto hit =
        std::ranges::find_if(margins, [](const auto& group) { return group["margin"] == "margin"; });
    EXPECT_EQ((*hit)["flips"], 1);
    EXPECT_EQ((*hit)["firstFlip"], (nlohmann::json{2, 1}));
}

TEST(CompareTruth, TheDifferencePictureShowsAFlipInGreen) {
    image::Image expected = truth();
    at(expected, "margin") = 0.0f;
    image::Image actual = values();
    at(actual, "id") = 9.0f;
    const auto colour = [&] {
        const image::Image picture = differenceImage(expected, actual, {});
        const std::span<const float> shown = picture.pixel(2, 1);
        return std::array<int, 3>{image::encodeSrgb(shown[0]), image::encodeSrgb(shown[1]),
                                  image::encodeSrgb(shown[2])};
    };
    EXPECT_EQ(colour(), (std::array{64, 192, 96}));
    at(actual, "count") = 9.0f;  // what is wrong goes before what may flip
    EXPECT_EQ(colour(), (std::array{255, 255, 255}));
    at(expected, "tolerance.uv") = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(colour(), (std::array{255, 0, 255}));
}

TEST(CompareTruth, TheMarginPictureShowsWhereItIsUnsureAndWhatFlipped) {
    image::Image expected = truth();
    at(expected, "margin", {1, 0}) = 0.0f;
    at(expected, "margin.count", {2, 0}) = 0.0f;
    image::Image actual = values();
    at(actual, "id", {1, 0}) = 9.0f;
    at(actual, "id", {2, 0}) = 9.0f;  // not what may flip there
    at(actual, "id", {3, 0}) = 9.0f;
    const image::Image picture = marginImage(expected, actual, {});
    const auto colour = [&](int x, int y) {
        const std::span<const float> shown = picture.pixel(x, y);
        return std::array<int, 3>{image::encodeSrgb(shown[0]), image::encodeSrgb(shown[1]),
                                  image::encodeSrgb(shown[2])};
    };
    EXPECT_EQ(colour(0, 0), (std::array{40, 44, 52}));
    EXPECT_EQ(colour(1, 0), (std::array{64, 192, 96}));
    EXPECT_EQ(colour(2, 0), (std::array{96, 160, 255}));
    EXPECT_EQ(colour(3, 0), (std::array{40, 44, 52}));
    expectError([&] { std::ignore = marginImage(expected, image::Image(2, 2, {"R"}), {}); },
                ExitCode::SizeDiffers, {"size"});
}

}  // namespace
}  // namespace raytorus::compare
