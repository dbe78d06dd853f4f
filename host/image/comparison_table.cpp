// SPDX-License-Identifier: MIT
// The numbers of a comparison as aligned columns.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "image/comparison_text.hpp"

namespace raytorus::image {

namespace {

std::string ruleText(const CompareRule& rule) {
    return rule.relativeTolerance > 0.0
               ? fmt::format("{:g} or {:g} rel", rule.tolerance, rule.relativeTolerance)
               : fmt::format("{:g}", rule.tolerance);
}

NumberRow channelRow(const ChannelComparison& channel) {
    const bool differs = channel.bitDifferent > 0;
    return {channel.name,
            ruleText(channel.rule),
            fmt::format("{:.4g}", channel.maxDifference),
            differs ? pixelText(channel.maxPixel) : "-",
            differs ? valueText(channel.expectedAtMax) : "-",
            differs ? valueText(channel.actualAtMax) : "-",
            fmt::format("{:.4g}", channel.meanDifference),
            fmt::format("{:.4g}", channel.rmsDifference),
            fmt::format("{}", channel.overLimit),
            fmt::format("{}", channel.bitDifferent)};
}

// The first column to the left, the numbers to the right.
std::string alignedText(const std::vector<NumberRow>& rows) {
    std::array<std::size_t, std::tuple_size_v<NumberRow>> widths{};
    for (const NumberRow& row : rows) {
        std::ranges::transform(row, widths, widths.begin(), [](const std::string& cell, std::size_t width) {
            return std::max(cell.size(), width);
        });
    }
    std::string text;
    for (const NumberRow& row : rows) {
        text += fmt::format("{:<{}}", row[0], widths[0]);
        for (std::size_t column = 1; column < row.size(); ++column) {
            text += fmt::format("  {:>{}}", row[column], widths[column]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace

std::vector<NumberRow> numberRows(const Comparison& comparison) {
    std::vector<NumberRow> rows = {{"channel", "tolerance", "max diff", "at", "expected", "actual",
                                    "mean diff", "rms diff", "over", "other bits"}};
    std::ranges::transform(comparison.channels, std::back_inserter(rows), channelRow);
    return rows;
}

std::string countsLine(const Comparison& comparison) {
    const CompareRules& rules = comparison.rules;
    return fmt::format(
        "{} x {} pixels: {} over the tolerance ({} allowed), at most {} in a {} x {} window{}; {} {} other "
        "bits",
        comparison.width, comparison.height, comparison.overLimitPixels, rules.allowedPixels,
        comparison.worstWindowCount, rules.windowSize, rules.windowSize,
        rules.windowLimit ? fmt::format(" ({} allowed)", *rules.windowLimit) : std::string(),
        comparison.bitDifferentValues, comparison.bitDifferentValues == 1 ? "value has" : "values have");
}

std::string numbersTable(const Comparison& comparison) {
    return comparison.channels.empty() ? std::string()
                                       : alignedText(numberRows(comparison)) + countsLine(comparison) + "\n";
}

}  // namespace raytorus::image
