// SPDX-License-Identifier: MIT
// Two images, one verdict, and the numbers behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare_rules.hpp"
#include "core/error.hpp"
#include "image/image.hpp"

namespace raytorus::compare {

/// In the order in which the gates are passed: the first that does not open gives the verdict.
enum class Verdict {
    SizeDiffers,  ///< another width, height, sample type or set of channels: nothing was compared
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

/// One channel of both images. Differences are formed in double precision. Against a truth, those of marginal
/// pixels are left out of all but bitDifferent.
struct ChannelComparison {
    std::string name;
    CompareRule rule;
    bool exact = false;       ///< the truth promises the value itself
    bool perPixel = false;    ///< the truth gives each pixel a tolerance, besides the rule
    std::int64_t judged = 0;  ///< values that were held to their limits
    double maxDifference = 0.0;
    Pixel maxPixel;  ///< where the largest difference is, the first such place
    float expectedAtMax = 0.0f;
    float actualAtMax = 0.0f;
    double maxRatio = 0.0;        ///< the largest of difference / limit; infinite where the limit is 0
    Pixel maxRatioPixel;          ///< where it is, the first such place
    double meanDifference = 0.0;  ///< of the absolute differences
    double rmsDifference = 0.0;
    std::int64_t overLimit = 0;     ///< values that do not agree
    std::int64_t bitDifferent = 0;  ///< values of which any bit differs: -0 and +0 do
};

/// The pixels where a truth leaves open what a group of channels is.
struct MarginalPixels {
    std::string margin;      ///< the channel that says so
    std::int64_t count = 0;  ///< where it is below 1
    std::int64_t flips = 0;  ///< of those, where any channel of the group is over its limit
    Pixel firstFlip;         ///< by rows, then columns
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
    std::vector<MarginalPixels> margins;      ///< of a truth, each of its margins
    bool againstTruth = false;                ///< the expected image is a truth, the actual one is none
    std::int64_t bitDifferentValues = 0;
    std::int64_t inexactValues = 0;    ///< values over their limits where the truth promises the value itself
    std::int64_t flippedPixels = 0;    ///< pixels with a flip in any group
    std::int64_t overLimitPixels = 0;  ///< pixels with any channel over its limit
    std::int64_t worstWindowCount = 0;  ///< the most of them in any windowSize x windowSize square
    Pixel worstWindow;                  ///< top left corner of the first such square

    [[nodiscard]] bool passed() const { return verdict == Verdict::Identical || verdict == Verdict::Agree; }
    [[nodiscard]] ExitCode exitCode() const;
};

/// The verdict where it needs no pixels, and the images may have none: SizeDiffers, or nothing.
[[nodiscard]] std::optional<Comparison> compareShapes(const image::Image& expected,
                                                      const image::Image& actual, const CompareRules& rules);

/// Compares channel by channel, by name: the order of channels does not matter. An expected image that is a
/// truth (image/channel_judge.hpp) is one: no pixel that it is sure of may break its exact promises, however
/// many are allowed; and where it leaves the verdict open, a difference is a flip, counted apart. Throws
/// Error{ExitCode::Usage} for rules that make no sense; everything that can be wrong with the images is in
/// the verdict.
[[nodiscard]] Comparison compare(const image::Image& expected, const image::Image& actual,
                                 const CompareRules& rules);

}  // namespace raytorus::compare
