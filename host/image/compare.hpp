// SPDX-License-Identifier: MIT
// Two images, one verdict, and the numbers behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "image/compare_rules.hpp"
#include "image/image.hpp"

namespace raytorus::image {

/// In the order in which the gates are passed: the first that does not open gives the verdict.
enum class Verdict {
    SizeDiffers,  ///< another width, height or set of channels: nothing was compared
    NonFinite,    ///< NaN or infinity in one of the images, the expected one included: nothing was compared
    Identical,    ///< the same bits everywhere
    Agree,        ///< not the same bits, but within the rules
    Differ,       ///< too many pixels over their limits
};

struct Pixel {
    int x = 0;  ///< from the left
    int y = 0;  ///< from the top

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The values of an image that are not numbers.
struct NonFiniteValues {
    std::int64_t count = 0;
    std::string channel;  ///< of the first one: by rows, then columns, then channels
    Pixel pixel;
    float value = 0.0f;
};

/// One channel of both images. Differences are formed in double precision.
struct ChannelComparison {
    std::string name;
    CompareRule rule;
    double maxDifference = 0.0;
    Pixel maxPixel;  ///< where the largest difference is, the first such place
    float expectedAtMax = 0.0f;
    float actualAtMax = 0.0f;
    double meanDifference = 0.0;  ///< of the absolute differences of all pixels
    double rmsDifference = 0.0;
    std::int64_t overLimit = 0;     ///< values that do not agree
    std::int64_t bitDifferent = 0;  ///< values of which any bit differs: -0 and +0 do
};

struct Comparison {
    Verdict verdict = Verdict::Identical;
    std::string sentence;  ///< the verdict with its reason, for people
    CompareRules rules;

    NonFiniteValues expectedNonFinite;
    NonFiniteValues actualNonFinite;

    // Filled only when the images were compared.
    int width = 0;
    int height = 0;
    std::vector<ChannelComparison> channels;  ///< in the order of the expected image
    std::int64_t bitDifferentValues = 0;
    std::int64_t overLimitPixels = 0;   ///< pixels with any channel over its limit
    std::int64_t worstWindowCount = 0;  ///< the most of them in any windowSize x windowSize square
    Pixel worstWindow;                  ///< top left corner of the first such square

    [[nodiscard]] bool passed() const { return verdict == Verdict::Identical || verdict == Verdict::Agree; }
    [[nodiscard]] ExitCode exitCode() const;
};

/// Compares channel by channel, by name: the order of channels does not matter. Throws Error{ExitCode::Usage}
/// for rules that make no sense; everything that can be wrong with the images is in the verdict.
[[nodiscard]] Comparison compare(const Image& expected, const Image& actual, const CompareRules& rules);

/// For every channel of `expected`, the index of the channel of the same name in `actual`. Empty when the two
/// do not have the same width, height and set of channels.
[[nodiscard]] std::vector<std::size_t> matchChannels(const Image& expected, const Image& actual);

}  // namespace raytorus::image
