// SPDX-License-Identifier: MIT
// A comparison in one sentence, and the words for verdicts and values.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/channel_judge.hpp"
#include "compare/comparison_text.hpp"

namespace raytorus::compare {

namespace {

std::string counted(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// "64 x 48 pixels with the channels R, G, B". What only a truth has is nothing that another image lacks.
std::string shapeText(const image::Image& image, bool withChannels, bool withTruth) {
    std::string text = fmt::format("{} x {} pixels", image.width, image.height);
    if (withChannels) {
        std::vector<std::string> names = image.channelNames;
        std::erase_if(names, [&](const std::string& name) { return !withTruth && isTruthChannel(name); });
        text += fmt::format(" with the channels {}", fmt::join(names, ", "));
    }
    return text;
}

const char* sampleTypeText(image::SampleType type) {
    switch (type) {
        case image::SampleType::Float32:
            return "32 bit floats";
        case image::SampleType::Float16:
            return "16 bit floats";
        case image::SampleType::Unsigned8:
            return "8 bit integers";
        case image::SampleType::Unsigned16:
            return "16 bit integers";
    }
    return "unknown values";
}

std::string sizeSentence(const image::Image& expected, const image::Image& actual) {
    if (expected.sampleType != actual.sampleType) {
        return fmt::format("The images cannot be compared: the expected one holds {}, the actual one {}.",
                           sampleTypeText(expected.sampleType), sampleTypeText(actual.sampleType));
    }
    image::Image sameSize = actual;
    sameSize.width = expected.width;
    sameSize.height = expected.height;
    const bool otherChannels = channelJudges(expected, sameSize, {}).empty();
    const bool withTruth = isTruth(actual) || !isTruth(expected);
    return fmt::format("The images cannot be compared: the expected one has {}, the actual one {}.",
                       shapeText(expected, otherChannels, withTruth), shapeText(actual, otherChannels, true));
}

std::string nonFinitePart(const char* which, const NonFiniteValues& values) {
    return fmt::format(
        "the {} image has {}, first {} in channel {} at pixel {}", which,
        counted(values.count, "value") + " that " + (values.count == 1 ? "is" : "are") + " not finite",
        valueText(values.value), values.channel, pixelText(values.pixel));
}

std::string nonFiniteSentence(const Comparison& comparison) {
    std::vector<std::string> parts;
    if (comparison.expectedNonFinite.count > 0) {
        parts.push_back(nonFinitePart("expected", comparison.expectedNonFinite));
    }
    if (comparison.actualNonFinite.count > 0) {
        parts.push_back(nonFinitePart("actual", comparison.actualNonFinite));
    }
    return fmt::format("The images cannot be compared: {}.", fmt::join(parts, ", and "));
}

// The channel to speak of: the worst among those over their limits, or among all when none is. What is worst
// is told by the limits of a truth, and by the differences themselves where one limit is for all.
const ChannelComparison& worstChannel(const Comparison& comparison) {
    return *std::ranges::max_element(comparison.channels, {}, [&](const ChannelComparison& channel) {
        return std::pair(channel.overLimit > 0,
                         comparison.againstTruth ? channel.maxRatio : channel.maxDifference);
    });
}

std::string largestPart(const Comparison& comparison) {
    const ChannelComparison& worst = worstChannel(comparison);
    if (comparison.againstTruth && std::isfinite(worst.maxRatio)) {
        return fmt::format("the largest difference is {:.3g} times the tolerance in channel {} at pixel {}",
                           worst.maxRatio, worst.name, pixelText(worst.maxRatioPixel));
    }
    return fmt::format("the largest difference is {:.3g} in channel {} at pixel {}", worst.maxDifference,
                       worst.name, pixelText(worst.maxPixel));
}

std::int64_t marginalPixels(const Comparison& comparison) {
    std::int64_t most = 0;
    for (const MarginalPixels& group : comparison.margins) {
        most = std::max(most, group.count);
    }
    return most;
}

// Nothing where there is nothing to flip.
std::string flipsPart(const Comparison& comparison) {
    return marginalPixels(comparison) == 0
               ? std::string()
               : fmt::format(", and {} flipped", counted(comparison.flippedPixels, "marginal pixel"));
}

std::string agreeSentence(const Comparison& comparison) {
    if (comparison.overLimitPixels == 0) {
        return fmt::format("The images agree within the tolerance: {}{}.", largestPart(comparison),
                           flipsPart(comparison));
    }
    return fmt::format("The images agree: {} over the tolerance, {} allowed, and {}{}.",
                       counted(comparison.overLimitPixels, "pixel"), comparison.rules.allowedPixels,
                       largestPart(comparison), flipsPart(comparison));
}

std::string inexactSentence(const Comparison& comparison) {
    const ChannelComparison& channel = *std::ranges::find_if(
        comparison.channels,
        [](const ChannelComparison& candidate) { return candidate.exact && candidate.overLimit > 0; });
    return fmt::format(
        "The images differ: {} not what the truth is sure of, the worst {} instead of {} in "
        "channel {} at pixel {}.",
        counted(comparison.inexactValues, "value") + (comparison.inexactValues == 1 ? " is" : " are"),
        valueText(channel.actualAtMax), valueText(channel.expectedAtMax), channel.name,
        pixelText(channel.maxPixel));
}

std::string flipsSentence(const Comparison& comparison) {
    const MarginalPixels& group = *std::ranges::max_element(comparison.margins, {}, &MarginalPixels::flips);
    return fmt::format("The images differ: {} flipped, {} allowed, the first of {} at pixel {}.",
                       counted(comparison.flippedPixels, "marginal pixel"),
                       comparison.rules.allowedFlips.value_or(0), group.margin, pixelText(group.firstFlip));
}

// The reasons in the order of the gates.
std::string differSentence(const Comparison& comparison) {
    const CompareRules& rules = comparison.rules;
    if (comparison.inexactValues > 0) {
        return inexactSentence(comparison);
    }
    if (comparison.overLimitPixels > rules.allowedPixels) {
        return fmt::format("The images differ: {} of {} over the tolerance, {} allowed, and {}.",
                           counted(comparison.overLimitPixels, "pixel"),
                           std::int64_t{comparison.width} * comparison.height, rules.allowedPixels,
                           largestPart(comparison));
    }
    if (rules.windowLimit && comparison.worstWindowCount > *rules.windowLimit) {
        return fmt::format(
            "The images differ: {} over the tolerance in the {} x {} window at {}, {} allowed, and {}.",
            counted(comparison.worstWindowCount, "pixel"), rules.windowSize, rules.windowSize,
            pixelText(comparison.worstWindow), *rules.windowLimit, largestPart(comparison));
    }
    return flipsSentence(comparison);
}

}  // namespace

std::string verdictName(Verdict verdict) {
    switch (verdict) {
        case Verdict::SizeDiffers:
            return "size differs";
        case Verdict::NonFinite:
            return "non-finite";
        case Verdict::Identical:
            return "identical";
        case Verdict::Agree:
            return "agree";
        case Verdict::Differ:
            return "differ";
    }
    return "unknown";
}

std::string pixelText(Pixel pixel) {
    return fmt::format("({}, {})", pixel.x, pixel.y);
}

std::string valueText(float value) {
    if (image::isFinite(value)) {
        return fmt::format("{}", value);
    }
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    if ((bits & 0x007fffffu) != 0) {
        return "NaN";
    }
    return (bits >> 31) != 0 ? "-Inf" : "+Inf";
}

std::string verdictSentence(const Comparison& comparison, const image::Image& expected,
                            const image::Image& actual) {
    switch (comparison.verdict) {
        case Verdict::SizeDiffers:
            return sizeSentence(expected, actual);
        case Verdict::NonFinite:
            return nonFiniteSentence(comparison);
        case Verdict::Identical:
            return "The images are identical.";
        case Verdict::Agree:
            return agreeSentence(comparison);
        case Verdict::Differ:
            return differSentence(comparison);
    }
    return {};
}

}  // namespace raytorus::compare
