// SPDX-License-Identifier: MIT
// A comparison in one sentence, and the words for verdicts and values.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "image/comparison_text.hpp"

namespace raytorus::image {

namespace {

std::string counted(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// "64 x 48 pixels with the channels R, G, B".
std::string shapeText(const Image& image) {
    return fmt::format("{} x {} pixels with the channels {}", image.width, image.height,
                       fmt::join(image.channelNames, ", "));
}

std::string sizeSentence(const Image& expected, const Image& actual) {
    return fmt::format("The images cannot be compared: the expected one has {}, the actual one {}.",
                       shapeText(expected), shapeText(actual));
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

// The channel to speak of: the largest difference among those over their limits, or among all when none is.
const ChannelComparison& worstChannel(const Comparison& comparison) {
    return *std::ranges::max_element(comparison.channels, {}, [](const ChannelComparison& channel) {
        return std::pair(channel.overLimit > 0, channel.maxDifference);
    });
}

std::string largestPart(const Comparison& comparison) {
    const ChannelComparison& worst = worstChannel(comparison);
    return fmt::format("the largest difference is {:.3g} in channel {} at pixel {}", worst.maxDifference,
                       worst.name, pixelText(worst.maxPixel));
}

std::string agreeSentence(const Comparison& comparison) {
    if (comparison.overLimitPixels == 0) {
        return fmt::format("The images agree within the tolerance: {}.", largestPart(comparison));
    }
    return fmt::format("The images agree: {} over the tolerance, {} allowed, and {}.",
                       counted(comparison.overLimitPixels, "pixel"), comparison.rules.allowedPixels,
                       largestPart(comparison));
}

std::string differSentence(const Comparison& comparison) {
    if (comparison.overLimitPixels > comparison.rules.allowedPixels) {
        return fmt::format("The images differ: {} of {} over the tolerance, {} allowed, and {}.",
                           counted(comparison.overLimitPixels, "pixel"),
                           std::int64_t{comparison.width} * comparison.height, comparison.rules.allowedPixels,
                           largestPart(comparison));
    }
    return fmt::format(
        "The images differ: {} over the tolerance in the {} x {} window at {}, {} allowed, and {}.",
        counted(comparison.worstWindowCount, "pixel"), comparison.rules.windowSize,
        comparison.rules.windowSize, pixelText(comparison.worstWindow),
        comparison.rules.windowLimit.value_or(0), largestPart(comparison));
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
    if (isFinite(value)) {
        return fmt::format("{}", value);
    }
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    if ((bits & 0x007fffffu) != 0) {
        return "NaN";
    }
    return (bits >> 31) != 0 ? "-Inf" : "+Inf";
}

std::string verdictSentence(const Comparison& comparison, const Image& expected, const Image& actual) {
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

}  // namespace raytorus::image
