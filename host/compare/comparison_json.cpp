// SPDX-License-Identifier: MIT
// A comparison as JSON, for programs.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "compare/comparison_text.hpp"
#include "core/json_text.hpp"

namespace raytorus::compare {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN and no infinity: they become the text that people see.
Json valueJson(float value) {
    return image::isFinite(value) ? Json(value) : Json(valueText(value));
}

Json ratioJson(double ratio) {
    return std::isfinite(ratio) ? Json(ratio) : Json("+Inf");
}

Json nonFiniteJson(const NonFiniteValues& values) {
    Json json = {{"count", values.count}};
    if (values.count > 0) {
        json["channel"] = values.channel;
        json["pixel"] = {values.pixel.x, values.pixel.y};
        json["value"] = valueJson(values.value);
    }
    return json;
}

Json channelJson(const ChannelComparison& channel) {
    return {{"name", channel.name},
            {"tolerance", channel.rule.tolerance},
            {"relativeTolerance", channel.rule.relativeTolerance},
            {"ulps", channel.rule.ulps},
            {"exact", channel.exact},
            {"perPixel", channel.perPixel},
            {"judged", channel.judged},
            {"maxDifference", channel.maxDifference},
            {"maxPixel", {channel.maxPixel.x, channel.maxPixel.y}},
            {"expectedAtMax", valueJson(channel.expectedAtMax)},
            {"actualAtMax", valueJson(channel.actualAtMax)},
            {"maxRatio", ratioJson(channel.maxRatio)},
            {"maxRatioPixel", {channel.maxRatioPixel.x, channel.maxRatioPixel.y}},
            {"meanDifference", channel.meanDifference},
            {"rmsDifference", channel.rmsDifference},
            {"overLimit", channel.overLimit},
            {"bitDifferent", channel.bitDifferent}};
}

Json marginJson(const MarginalPixels& group) {
    Json json = {{"margin", group.margin}, {"marginal", group.count}, {"flips", group.flips}};
    if (group.flips > 0) {
        json["firstFlip"] = {group.firstFlip.x, group.firstFlip.y};
    }
    return json;
}

}  // namespace

std::string jsonText(const Comparison& comparison) {
    Json json = {{"verdict", verdictName(comparison.verdict)},
                 {"passed", comparison.passed()},
                 {"exitCode", static_cast<int>(comparison.exitCode())},
                 {"sentence", comparison.sentence},
                 {"nonFinite",
                  {{"expected", nonFiniteJson(comparison.expectedNonFinite)},
                   {"actual", nonFiniteJson(comparison.actualNonFinite)}}}};
    if (!comparison.channels.empty()) {
        json["width"] = comparison.width;
        json["height"] = comparison.height;
        json["overLimitPixels"] = comparison.overLimitPixels;
        json["allowedPixels"] = comparison.rules.allowedPixels;
        json["windowSize"] = comparison.rules.windowSize;
        json["windowLimit"] = comparison.rules.windowLimit ? Json(*comparison.rules.windowLimit) : Json();
        json["worstWindowCount"] = comparison.worstWindowCount;
        json["worstWindow"] = {comparison.worstWindow.x, comparison.worstWindow.y};
        json["againstTruth"] = comparison.againstTruth;
        json["inexactValues"] = comparison.inexactValues;
        json["flippedPixels"] = comparison.flippedPixels;
        json["allowedFlips"] = comparison.rules.allowedFlips ? Json(*comparison.rules.allowedFlips) : Json();
        json["margins"] = Json::array();
        std::ranges::transform(comparison.margins, std::back_inserter(json["margins"]), marginJson);
        json["bitDifferentValues"] = comparison.bitDifferentValues;
        json["channels"] = Json::array();
        std::ranges::transform(comparison.channels, std::back_inserter(json["channels"]), channelJson);
    }
    return dumpJson(json);
}

}  // namespace raytorus::compare
