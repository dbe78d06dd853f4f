// SPDX-License-Identifier: MIT
// Where two images differ, and whether it matters.
#include "compare/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "compare/channel_judge.hpp"
#include "core/error.hpp"
#include "image/channels.hpp"
#include "image/srgb.hpp"

namespace raytorus::compare {

namespace {

using Colour = std::array<double, 3>;  // as shown: sRGB, 0 to 255

constexpr Colour black = {0, 0, 0};
constexpr Colour darkGrey = {40, 44, 52};
constexpr Colour darkBlue = {24, 48, 128};
constexpr Colour lightBlue = {96, 160, 255};
constexpr Colour orange = {255, 112, 0};
constexpr Colour yellow = {255, 224, 64};
constexpr Colour white = {255, 255, 255};
constexpr Colour green = {64, 192, 96};
constexpr Colour magenta = {255, 0, 255};

// How many powers of ten over the limit the colours from orange to white show.
constexpr double decades = 3.0;

// Stands for the limit where nothing is tolerated: about ten last bits of a float near 1.
constexpr double exactScale = 1e-6;

Colour between(const Colour& from, const Colour& to, double t) {
    return {std::lerp(from[0], to[0], t), std::lerp(from[1], to[1], t), std::lerp(from[2], to[2], t)};
}

// Position on the whole scale: 0 is equal, up to 1 is within the limit, 1 + n is 10^n limits.
double severity(double difference, double limit) {
    if (difference <= 0.0) {
        return 0.0;
    }
    if (difference <= limit) {
        return difference / limit;
    }
    return 1.0 + std::max(0.0, std::log10(difference / (limit > 0.0 ? limit : exactScale)));
}

Colour ramp(double position, bool overLimit) {
    if (position <= 0.0) {
        return black;
    }
    if (!overLimit) {
        return between(darkBlue, lightBlue, position);
    }
    const double t = std::min((position - 1.0) / decades, 1.0);
    return t < 0.5 ? between(orange, yellow, 2.0 * t) : between(yellow, white, 2.0 * t - 1.0);
}

Colour pixelColour(std::span<const float> expectedPixel, std::span<const float> actualPixel,
                   std::span<const ChannelJudge> judges) {
    double worst = 0.0;
    bool overLimit = false;
    bool flipped = false;
    for (const ChannelJudge& judge : judges) {
        if (!image::isFinite(actualPixel[judge.actual])) {
            return magenta;
        }
        const double difference = judge.difference(expectedPixel, actualPixel);
        const double limit = judge.limit(expectedPixel);
        const bool over = difference > limit;
        if (over && judge.marginal(expectedPixel)) {
            flipped = true;
            continue;
        }
        worst = std::max(worst, severity(difference, limit));
        overLimit |= over;
    }
    return flipped && !overLimit ? green : ramp(worst, overLimit);
}

Colour marginColour(std::span<const float> expectedPixel, std::span<const float> actualPixel,
                    std::span<const ChannelJudge> judges) {
    bool marginal = false;
    for (const ChannelJudge& judge : judges) {
        if (judge.marginal(expectedPixel)) {
            if (judge.difference(expectedPixel, actualPixel) > judge.limit(expectedPixel)) {
                return green;
            }
            marginal = true;
        }
    }
    return marginal ? lightBlue : darkGrey;
}

using ColourOf = Colour(std::span<const float> expectedPixel, std::span<const float> actualPixel,
                        std::span<const ChannelJudge> judges);

image::Image paint(const image::Image& expected, const image::Image& actual, const CompareRules& rules,
                   ColourOf* colourOf) {
    const std::vector<ChannelJudge> judges = channelJudges(expected, actual, rules);
    if (judges.empty()) {
        throw Error(ExitCode::SizeDiffers,
                    "there is no difference picture of images of other size or channels");
    }
    image::Image picture(expected.width, expected.height, image::channelsOf({image::ChannelKind::Color}));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            // Those that only a truth has, its margins and tolerances, are numbers too.
            const std::span<const float> expectedPixel = expected.pixel(x, y);
            const Colour colour = std::ranges::all_of(expectedPixel, image::isFinite)
                                      ? colourOf(expectedPixel, actual.pixel(x, y), judges)
                                      : magenta;
            std::ranges::transform(colour, picture.pixel(x, y).begin(), [](double shown) {
                return image::decodeSrgb(static_cast<std::uint8_t>(std::lround(shown)));
            });
        }
    }
    return picture;
}

std::size_t binOf(double difference, double limit) {
    double ratio = 0.0;
    if (difference > 0.0) {
        ratio = limit > 0.0 ? difference / limit : std::numeric_limits<double>::infinity();
    }
    const auto* const end = std::ranges::lower_bound(histogramEnds, ratio);
    return static_cast<std::size_t>(end - histogramEnds.begin());
}

}  // namespace

image::Image differenceImage(const image::Image& expected, const image::Image& actual,
                             const CompareRules& rules) {
    return paint(expected, actual, rules, pixelColour);
}

image::Image marginImage(const image::Image& expected, const image::Image& actual,
                         const CompareRules& rules) {
    return paint(expected, actual, rules, marginColour);
}

DifferenceHistogram differenceHistogram(const image::Image& expected, const image::Image& actual,
                                        const CompareRules& rules) {
    DifferenceHistogram histogram;
    const std::vector<ChannelJudge> judges = channelJudges(expected, actual, rules);
    for (int y = 0; !judges.empty() && y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const std::span<const float> expectedPixel = expected.pixel(x, y);
            const std::span<const float> actualPixel = actual.pixel(x, y);
            for (const ChannelJudge& judge : judges) {
                if (!image::isFinite(expectedPixel[judge.expected]) ||
                    !image::isFinite(actualPixel[judge.actual])) {
                    ++histogram.notFinite;
                } else if (judge.marginal(expectedPixel)) {
                    ++histogram.marginal;
                } else {
                    ++histogram.counts[binOf(judge.difference(expectedPixel, actualPixel),
                                             judge.limit(expectedPixel))];
                }
            }
        }
    }
    return histogram;
}

}  // namespace raytorus::compare
