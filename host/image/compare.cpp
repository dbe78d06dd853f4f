// SPDX-License-Identifier: MIT
// The gates: shape, then non-finite values, then bits, then the rule for each pixel, then clusters.
#include "image/compare.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "image/comparison_text.hpp"

namespace raytorus::image {

namespace {

// OpenImageIO's own comparison lets an image of nothing but NaN pass, hence a gate before any difference.
NonFiniteValues findNonFinite(const Image& image) {
    NonFiniteValues found;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::span<const float> values = image.pixel(x, y);
            for (std::size_t channel = 0; channel < values.size(); ++channel) {
                if (!isFinite(values[channel]) && found.count++ == 0) {
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
bool addValue(ChannelComparison& channel, float expected, float actual, Pixel pixel) {
    if (std::bit_cast<std::uint32_t>(expected) == std::bit_cast<std::uint32_t>(actual)) {
        return false;
    }
    ++channel.bitDifferent;
    const double difference = std::abs(static_cast<double>(actual) - static_cast<double>(expected));
    channel.meanDifference += difference;
    channel.rmsDifference += difference * difference;
    if (difference > channel.maxDifference || channel.bitDifferent == 1) {
        channel.maxDifference = difference;
        channel.maxPixel = pixel;
        channel.expectedAtMax = expected;
        channel.actualAtMax = actual;
    }
    const bool over = !(difference <= channel.rule.limit(expected));
    channel.overLimit += over ? 1 : 0;
    return over;
}

void finishChannel(ChannelComparison& channel, double pixelCount) {
    channel.meanDifference /= pixelCount;
    channel.rmsDifference = std::sqrt(channel.rmsDifference / pixelCount);
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

void compareValues(Comparison& result, const Image& expected, const Image& actual,
                   const std::vector<std::size_t>& actualChannel) {
    result.width = expected.width;
    result.height = expected.height;
    for (const std::string& name : expected.channelNames) {
        ChannelComparison& channel = result.channels.emplace_back();
        channel.name = name;
        channel.rule = result.rules.ruleFor(name);
    }
    std::vector<std::uint8_t> marks;
    marks.reserve(static_cast<std::size_t>(expected.width) * static_cast<std::size_t>(expected.height));
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const std::span<const float> expectedValues = expected.pixel(x, y);
            const std::span<const float> actualValues = actual.pixel(x, y);
            bool over = false;
            for (std::size_t channel = 0; channel < expectedValues.size(); ++channel) {
                over |= addValue(result.channels[channel], expectedValues[channel],
                                 actualValues[actualChannel[channel]], {x, y});
            }
            result.overLimitPixels += over ? 1 : 0;
            marks.push_back(over ? 1 : 0);
        }
    }
    for (ChannelComparison& channel : result.channels) {
        finishChannel(channel, static_cast<double>(marks.size()));
        result.bitDifferentValues += channel.bitDifferent;
    }
    findWorstWindow(result, marks);
}

Verdict verdictOf(const Comparison& result) {
    if (result.bitDifferentValues == 0) {
        return Verdict::Identical;
    }
    const bool clustered = result.rules.windowLimit && result.worstWindowCount > *result.rules.windowLimit;
    return result.overLimitPixels > result.rules.allowedPixels || clustered ? Verdict::Differ
                                                                            : Verdict::Agree;
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

std::vector<std::size_t> matchChannels(const Image& expected, const Image& actual) {
    std::vector<std::size_t> match;
    if (expected.width != actual.width || expected.height != actual.height ||
        expected.channelNames.size() != actual.channelNames.size()) {
        return match;
    }
    for (const std::string& name : expected.channelNames) {
        const int index = actual.channelIndex(name);
        if (index < 0) {
            return {};
        }
        match.push_back(static_cast<std::size_t>(index));
    }
    return match;
}

Comparison compare(const Image& expected, const Image& actual, const CompareRules& rules) {
    Comparison result;
    result.rules = rules;
    const std::vector<std::size_t> actualChannel = matchChannels(expected, actual);
    if (actualChannel.empty()) {
        result.verdict = Verdict::SizeDiffers;
    } else {
        checkRules(rules, expected.channelNames);
        result.expectedNonFinite = findNonFinite(expected);
        result.actualNonFinite = findNonFinite(actual);
        if (result.expectedNonFinite.count + result.actualNonFinite.count > 0) {
            result.verdict = Verdict::NonFinite;
        } else {
            compareValues(result, expected, actual, actualChannel);
            result.verdict = verdictOf(result);
        }
    }
    result.sentence = verdictSentence(result, expected, actual);
    return result;
}

}  // namespace raytorus::image
