// SPDX-License-Identifier: MIT
// The numbers of a comparison as aligned columns.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "compare/comparison_text.hpp"

namespace raytorus::compare {

namespace {

// "exact", "1e-05", "0 or 4 ulp", "per pixel", "per pixel or 1e-05".
std::string ruleText(const ChannelComparison& channel) {
    const CompareRule& rule = channel.rule;
    std::vector<std::string> limits;
    if (channel.perPixel) {
        limits.emplace_back("per pixel");
    }
    if (rule.tolerance > 0.0) {
        limits.push_back(fmt::format("{:g}", rule.tolerance));
    }
    if (rule.relativeTolerance > 0.0) {
        limits.push_back(fmt::format("{:g} rel", rule.relativeTolerance));
    }
    if (rule.ulps > 0) {
        limits.push_back(fmt::format("{} ulp", rule.ulps));
    }
    if (limits.empty()) {
        return channel.exact ? "exact" : "0";
    }
    return fmt::format("{}", fmt::join(limits, " or "));
}

NumberRow channelRow(const ChannelComparison& channel) {
    const bool differs = channel.maxDifference > 0.0;
    return {channel.name,
            ruleText(channel),
            fmt::format("{:.4g}", channel.maxDifference),
            differs ? pixelText(channel.maxPixel) : "-",
            differs ? valueText(channel.expectedAtMax) : "-",
            differs ? valueText(channel.actualAtMax) : "-",
            fmt::format("{:.3g}", channel.maxRatio),
            differs ? pixelText(channel.maxRatioPixel) : "-",
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
                                    "of limit", "at", "mean diff", "rms diff", "over", "other bits"}};
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

std::vector<std::string> marginLines(const Comparison& comparison) {
    std::vector<std::string> lines;
    for (const MarginalPixels& group : comparison.margins) {
        lines.push_back(fmt::format("{}: {} marginal, {} flipped{}", group.margin, group.count, group.flips,
                                    group.flips > 0 ? ", first at " + pixelText(group.firstFlip) : ""));
    }
    if (!lines.empty()) {
        lines.push_back(fmt::format("{} {} flipped in any of them ({} allowed)", comparison.flippedPixels,
                                    comparison.flippedPixels == 1 ? "pixel" : "pixels",
                                    comparison.rules.allowedFlips
                                        ? fmt::format("{}", *comparison.rules.allowedFlips)
                                        : std::string("all")));
    }
    return lines;
}

std::string numbersTable(const Comparison& comparison) {
    if (comparison.channels.empty()) {
        return {};
    }
    std::string text = alignedText(numberRows(comparison)) + countsLine(comparison) + "\n";
    for (const std::string& line : marginLines(comparison)) {
        text += line + "\n";
    }
    return text;
}

}  // namespace raytorus::compare
