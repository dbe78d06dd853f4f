// SPDX-License-Identifier: MIT
// A comparison as JSON, for programs.
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "image/comparison_text.hpp"

namespace raytorus::image {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN and no infinity: they become the text that people see.
Json valueJson(float value) {
    return isFinite(value) ? Json(value) : Json(valueText(value));
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
            {"maxDifference", channel.maxDifference},
            {"maxPixel", {channel.maxPixel.x, channel.maxPixel.y}},
            {"expectedAtMax", valueJson(channel.expectedAtMax)},
            {"actualAtMax", valueJson(channel.actualAtMax)},
            {"meanDifference", channel.meanDifference},
            {"rmsDifference", channel.rmsDifference},
            {"overLimit", channel.overLimit},
            {"bitDifferent", channel.bitDifferent}};
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
        json["bitDifferentValues"] = comparison.bitDifferentValues;
        json["channels"] = Json::array();
        std::ranges::transform(comparison.channels, std::back_inserter(json["channels"]), channelJson);
    }
    // Channel names come from files: what is not UTF-8 in them is replaced, not an exception.
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace raytorus::image
