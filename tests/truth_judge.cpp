// SPDX-License-Identifier: MIT
#include "truth_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace raytorus::test {
namespace {

struct Rule {
    const char* channel;
    const char* margin;
    int tolerance;  // into TruthJudgement::tolerances; -1: exact
};

constexpr std::array rules = {Rule{"R", "margin.color", 0},    Rule{"G", "margin.color", 0},
                              Rule{"B", "margin.color", 0},    Rule{"A", "margin.color", -1},
                              Rule{"t", "margin", 1},          Rule{"position.x", "margin", 2},
                              Rule{"position.y", "margin", 2}, Rule{"position.z", "margin", 2},
                              Rule{"normal.x", "margin", 3},   Rule{"normal.y", "margin", 3},
                              Rule{"normal.z", "margin", 3},   Rule{"uv.u", "margin", 4},
                              Rule{"uv.v", "margin", 4},       Rule{"count", "margin.count", -1},
                              Rule{"id", "margin", -1}};

constexpr std::array toleranceChannels = {"tolerance.color", "tolerance.t", "tolerance.position",
                                          "tolerance.normal", "tolerance.uv"};

double differenceOf(std::string_view channel, float expected, float actual) {
    const double apart = std::abs(static_cast<double>(expected) - static_cast<double>(actual));
    // Round the axis and round the tube, 0 and 1 are the same place.
    return channel.starts_with("uv.") ? std::min(apart, std::abs(1.0 - apart)) : apart;
}

}  // namespace

void TruthJudgement::add(const TruthJudgement& other) {
    faults.insert(faults.end(), other.faults.begin(), other.faults.end());
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
        tolerances[i].channel = other.tolerances[i].channel;
        tolerances[i].largestRatio = std::max(tolerances[i].largestRatio, other.tolerances[i].largestRatio);
        tolerances[i].largestTolerance =
            std::max(tolerances[i].largestTolerance, other.tolerances[i].largestTolerance);
    }
    seconds += other.seconds;
    pixels += other.pixels;
    doubtful += other.doubtful;
    doubtfulCount += other.doubtfulCount;
    doubtfulColor += other.doubtfulColor;
    flipped += other.flipped;
}

TruthJudgement judgeByTruth(const image::Image& truth, const image::Image& actual) {
    TruthJudgement judgement;
    for (std::size_t i = 0; i < toleranceChannels.size(); ++i) {
        judgement.tolerances[i].channel = toleranceChannels[i];
    }
    const auto value = [](const image::Image& picture, int x, int y, const char* channel) {
        return picture.pixel(x, y)[static_cast<std::size_t>(picture.channelIndex(channel))];
    };
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            ++judgement.pixels;
            judgement.doubtful += value(truth, x, y, "margin") < 1.0F ? 1 : 0;
            judgement.doubtfulCount += value(truth, x, y, "margin.count") < 1.0F ? 1 : 0;
            judgement.doubtfulColor += value(truth, x, y, "margin.color") < 1.0F ? 1 : 0;
            bool flipped = false;
            for (const Rule& rule : rules) {
                const float margin = value(truth, x, y, rule.margin);
                const float expected = value(truth, x, y, rule.channel);
                const float got = value(actual, x, y, rule.channel);
                if (margin < 1.0F) {
                    flipped = flipped || (rule.tolerance < 0 && expected != got);
                    continue;
                }
                const double difference = differenceOf(rule.channel, expected, got);
                double tolerance = 0.0;
                if (rule.tolerance >= 0) {
                    ToleranceUse& use = judgement.tolerances[static_cast<std::size_t>(rule.tolerance)];
                    tolerance = static_cast<double>(value(truth, x, y, use.channel));
                    use.largestTolerance = std::max(use.largestTolerance, tolerance);
                    if (tolerance > 0.0) {
                        use.largestRatio = std::max(use.largestRatio, difference / tolerance);
                    }
                }
                if (!(difference <= tolerance)) {
                    judgement.faults.push_back(
                        fmt::format("pixel ({}, {}), {}: {:.9g} in place of {:.9g}, off by {:.3g}, {:.3g} is "
                                    "allowed, margin {:g}",
                                    x, y, rule.channel, got, expected, difference, tolerance, margin));
                }
            }
            judgement.flipped += flipped ? 1 : 0;
        }
    }
    return judgement;
}

}  // namespace raytorus::test
