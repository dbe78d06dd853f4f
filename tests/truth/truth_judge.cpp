// SPDX-License-Identifier: MIT
#include "truth_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/compare.hpp"

namespace raytorus::test {
namespace {

constexpr std::array tolerances = {"color", "t", "position", "normal", "uv"};

// The tolerance that a channel has: "position" for "position.x", "color" for "R".
bool belongsTo(const std::string& channel, std::string_view tolerance) {
    return tolerance == "color" ? channel == "R" || channel == "G" || channel == "B"
                                : channel.substr(0, channel.find('.')) == tolerance;
}

}  // namespace

void TruthJudgement::add(const TruthJudgement& other) {
    faults.insert(faults.end(), other.faults.begin(), other.faults.end());
    for (std::size_t i = 0; i < uses.size(); ++i) {
        uses[i].tolerance = other.uses[i].tolerance;
        uses[i].largestRatio = std::max(uses[i].largestRatio, other.uses[i].largestRatio);
    }
    seconds += other.seconds;
    pixels += other.pixels;
    doubtful += other.doubtful;
    doubtfulCount += other.doubtfulCount;
    doubtfulColor += other.doubtfulColor;
    flipped += other.flipped;
}

TruthJudgement judgeByTruth(const image::Image& truth, const image::Image& actual) {
    const compare::Comparison comparison = compare::compare(truth, actual, {});
    TruthJudgement judgement;
    judgement.pixels = truth.width * truth.height;
    judgement.flipped = comparison.flippedPixels;
    for (const compare::MarginalPixels& margin : comparison.margins) {
        (margin.margin == "margin"         ? judgement.doubtful
         : margin.margin == "margin.count" ? judgement.doubtfulCount
                                           : judgement.doubtfulColor) = margin.count;
    }
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
        judgement.uses[i].tolerance = tolerances[i];
    }
    for (const compare::ChannelComparison& channel : comparison.channels) {
        for (ToleranceUse& use : judgement.uses) {
            if (belongsTo(channel.name, use.tolerance)) {
                use.largestRatio = std::max(use.largestRatio, channel.maxRatio);
            }
        }
        if (channel.overLimit > 0) {
            judgement.faults.push_back(fmt::format(
                "{}: {} values are off, the worst by {:.3g} times what pixel ({}, {}) allows", channel.name,
                channel.overLimit, channel.maxRatio, channel.maxRatioPixel.x, channel.maxRatioPixel.y));
        }
    }
    // What no channel has to show: another size, other channels, a value that is not finite.
    if (!comparison.passed() && judgement.faults.empty()) {
        judgement.faults.push_back(comparison.sentence);
    }
    return judgement;
}

}  // namespace raytorus::test
