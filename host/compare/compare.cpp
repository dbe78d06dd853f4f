// SPDX-License-Identifier: MIT
// The gates: shape, then non-finite values, then bits, then what a truth promises exactly, then the rule for
// each pixel, then clusters, then flips.
#include "compare/compare.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "compare/channel_judge.hpp"
#include "compare/comparison_text.hpp"

namespace raytorus::compare {

namespace {

// OpenImageIO's own comparison lets an image of nothing but NaN pass, hence a gate before any difference.
NonFiniteValues findNonFinite(const image::Image& image) {
    NonFiniteValues found;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::span<const float> values = image.pixel(x, y);
            for (std::size_t channel = 0; channel < values.size(); ++channel) {
                if (!image::isFinite(values[channel]) && found.count++ == 0) {
                    found.channel = image.channelNames[channel];
                    found.pixel = {x, y};
                    found.value = values[channel];
                }
            }
        }
    }
    return found;
}

// Sums a value into its channel; says whether it is over its limit. meanDifference and rmsDifference are sums
// until finishChannel().
bool addValue(ChannelComparison& channel, const ChannelJudge& judge, std::span<const float> expectedPixel,
              std::span<const float> actualPixel, Pixel pixel) {
    ++channel.judged;
    const double difference = judge.difference(expectedPixel, actualPixel);
    if (difference == 0.0) {
        return false;
    }
    channel.meanDifference += difference;
    channel.rmsDifference += difference * difference;
    if (difference > channel.maxDifference) {
        channel.maxDifference = difference;
        channel.maxPixel = pixel;
        channel.expectedAtMax = expectedPixel[judge.expected];
        channel.actualAtMax = actualPixel[judge.actual];
    }
    const double limit = judge.limit(expectedPixel);
    const double ratio = limit > 0.0 ? difference / limit : std::numeric_limits<double>::infinity();
    if (ratio > channel.maxRatio) {
        channel.maxRatio = ratio;
        channel.maxRatioPixel = pixel;
    }
    const bool over = !(difference <= limit);
    channel.overLimit += over ? 1 : 0;
    return over;
}

void finishChannel(ChannelComparison& channel) {
    const double count = static_cast<double>(std::max<std::int64_t>(channel.judged, 1));
    channel.meanDifference /= count;
    channel.rmsDifference = std::sqrt(channel.rmsDifference / count);
}

bool bitsDiffer(float one, float other) {
    return std::bit_cast<std::uint32_t>(one) != std::bit_cast<std::uint32_t>(other);
}

// The square with the most marked pixels. Sums slide, so the time does not grow with the square.
void findWorstWindow(Comparison& result, const std::vector<std::uint8_t>& marks) {
    const auto width = static_cast<std::size_t>(result.width);
    const auto height = static_cast<std::size_t>(result.height);
    const auto side = static_cast<std::size_t>(result.rules.windowSize);
    const std::size_t across = std::min(side, width);
    const std::size_t down = std::min(side, height);
    std::vector<std::int64_t> columns(width, 0);  // marks of each column in the current band of rows
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            columns[x] += marks[y * width + x];
            columns[x] -= y >= down ? marks[(y - down) * width + x] : 0;
        }
        if (y + 1 < down) {
            continue;
        }
        std::int64_t count = 0;
        for (std::size_t x = 0; x < width; ++x) {
            count += columns[x];
            count -= x >= across ? columns[x - across] : 0;
            if (x + 1 >= across && count > result.worstWindowCount) {
                result.worstWindowCount = count;
                result.worstWindow = {static_cast<int>(x + 1 - across), static_cast<int>(y + 1 - down)};
            }
        }
    }
}

// The margins of a truth, and for each judge the place of its own among them.
struct Margins {
    std::vector<std::size_t> channels;  // of the expected image
    std::vector<std::optional<std::size_t>> places;
};

Margins findMargins(std::span<const ChannelJudge> judges) {
    Margins margins;
    for (const ChannelJudge& judge : judges) {
        std::optional<std::size_t>& place = margins.places.emplace_back();
        if (judge.margin) {
            const auto found = std::ranges::find(margins.channels, *judge.margin);
            place = static_cast<std::size_t>(found - margins.channels.begin());
            if (found == margins.channels.end()) {
                margins.channels.push_back(*judge.margin);
            }
        }
    }
    return margins;
}

void addMarginalPixel(Comparison& result, const Margins& margins, std::span<const float> expectedPixel,
                      std::span<const std::uint8_t> flipped, Pixel pixel) {
    bool any = false;
    for (std::size_t i = 0; i < flipped.size(); ++i) {
        MarginalPixels& group = result.margins[i];
        group.count += expectedPixel[margins.channels[i]] < 1.0f ? 1 : 0;
        if (flipped[i] != 0 && group.flips++ == 0) {
            group.firstFlip = pixel;
        }
        any |= flipped[i] != 0;
    }
    result.flippedPixels += any ? 1 : 0;
}

// What will be counted: nothing yet.
void startCounting(Comparison& result, const image::Image& expected, std::span<const ChannelJudge> judges,
                   const Margins& margins) {
    result.width = expected.width;
    result.height = expected.height;
    for (const ChannelJudge& judge : judges) {
        ChannelComparison& channel = result.channels.emplace_back();
        channel.name = judge.name;
        channel.rule = judge.rule;
        channel.exact = judge.exact;
        channel.perPixel = judge.tolerance.has_value();
    }
    for (const std::size_t channel : margins.channels) {
        result.margins.emplace_back().margin = expected.channelNames[channel];
    }
}

void compareValues(Comparison& result, const image::Image& expected, const image::Image& actual,
                   std::span<const ChannelJudge> judges) {
    const Margins margins = findMargins(judges);
    startCounting(result, expected, judges, margins);
    std::vector<std::uint8_t> marks;
    marks.reserve(static_cast<std::size_t>(expected.width) * static_cast<std::size_t>(expected.height));
    std::vector<std::uint8_t> flipped(margins.channels.size());
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const std::span<const float> expectedPixel = expected.pixel(x, y);
            const std::span<const float> actualPixel = actual.pixel(x, y);
            bool over = false;
            std::ranges::fill(flipped, std::uint8_t{0});
            for (std::size_t i = 0; i < judges.size(); ++i) {
                const ChannelJudge& judge = judges[i];
                ChannelComparison& channel = result.channels[i];
                channel.bitDifferent +=
                    bitsDiffer(expectedPixel[judge.expected], actualPixel[judge.actual]) ? 1 : 0;
                if (!judge.marginal(expectedPixel)) {
                    over |= addValue(channel, judge, expectedPixel, actualPixel, {x, y});
                } else if (judge.difference(expectedPixel, actualPixel) > judge.limit(expectedPixel)) {
                    flipped[*margins.places[i]] = 1;
                }
            }
            addMarginalPixel(result, margins, expectedPixel, flipped, {x, y});
            result.overLimitPixels += over ? 1 : 0;
            marks.push_back(over ? 1 : 0);
        }
    }
    for (ChannelComparison& channel : result.channels) {
        finishChannel(channel);
        result.bitDifferentValues += channel.bitDifferent;
        result.inexactValues += channel.exact ? channel.overLimit : 0;
    }
    findWorstWindow(result, marks);
}

Verdict verdictOf(const Comparison& result) {
    if (result.bitDifferentValues == 0) {
        return Verdict::Identical;
    }
    const CompareRules& rules = result.rules;
    const bool differ = result.inexactValues > 0 || result.overLimitPixels > rules.allowedPixels ||
                        (rules.windowLimit && result.worstWindowCount > *rules.windowLimit) ||
                        (rules.allowedFlips && result.flippedPixels > *rules.allowedFlips);
    return differ ? Verdict::Differ : Verdict::Agree;
}

}  // namespace

ExitCode Comparison::exitCode() const {
    switch (verdict) {
        case Verdict::SizeDiffers:
            return ExitCode::SizeDiffers;
        case Verdict::NonFinite:
            return ExitCode::NonFinite;
        case Verdict::Differ:
            return ExitCode::ComparisonFailed;
        case Verdict::Identical:
        case Verdict::Agree:
            return ExitCode::Ok;
    }
    return ExitCode::Internal;
}

std::optional<Comparison> compareShapes(const image::Image& expected, const image::Image& actual,
                                        const CompareRules& rules) {
    if (!channelJudges(expected, actual, rules).empty()) {
        return std::nullopt;
    }
    Comparison result;
    result.rules = rules;
    result.verdict = Verdict::SizeDiffers;
    result.sentence = verdictSentence(result, expected, actual);
    return result;
}

Comparison compare(const image::Image& expected, const image::Image& actual, const CompareRules& rules) {
    if (std::optional<Comparison> shapes = compareShapes(expected, actual, rules)) {
        return *std::move(shapes);
    }
    Comparison result;
    result.rules = rules;
    const std::vector<ChannelJudge> judges = channelJudges(expected, actual, rules);
    result.againstTruth = judges.size() < expected.channelNames.size();
    checkRules(rules, actual.channelNames, result.againstTruth);
    result.expectedNonFinite = findNonFinite(expected);
    result.actualNonFinite = findNonFinite(actual);
    if (result.expectedNonFinite.count + result.actualNonFinite.count > 0) {
        result.verdict = Verdict::NonFinite;
    } else {
        compareValues(result, expected, actual, judges);
        result.verdict = verdictOf(result);
    }
    result.sentence = verdictSentence(result, expected, actual);
    return result;
}

}  // namespace raytorus::compare
