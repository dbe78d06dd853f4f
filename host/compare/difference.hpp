// SPDX-License-Identifier: MIT
// Where two images differ, and whether it matters: as pictures, and counted by size.
#pragma once

#include <array>
#include <cstdint>

#include "compare/compare_rules.hpp"
#include "image/image.hpp"

namespace raytorus::compare {

/// R, G, B of the size of both images, to be written as PNG. A pixel shows the worst of its channels,
/// measured in limits (ChannelJudge::limit), so that what is tolerated and what is not never look alike:
///   black                   the same values
///   dark to light blue      a difference within the limit, up to the limit itself
///   orange, yellow, white   over the limit, up to 1000 times it; the scale is logarithmic
///   green                   a flip: over the limit where a truth leaves the value open, and nowhere else
///   magenta                 a value that is not finite in either image
/// Where the limit is 0, orange starts at a difference of 0 and white is reached at 1e-3.
/// Throws Error{ExitCode::SizeDiffers} when the images do not have the same size and channels.
[[nodiscard]] image::Image differenceImage(const image::Image& expected, const image::Image& actual,
                                           const CompareRules& rules);

/// R, G, B: where a truth is sure, and what came of where it is not.
///   dark grey    sure of every channel
///   blue         marginal for some, and the actual image is what was expected there
///   green        a flip
/// Throws Error{ExitCode::SizeDiffers} like differenceImage().
[[nodiscard]] image::Image marginImage(const image::Image& expected, const image::Image& actual,
                                       const CompareRules& rules);

/// Upper ends of the bins but the last, in limits of the value (ChannelJudge::limit): the first bin holds
/// what is equal, the last what is more than 1000 limits off. A value with a limit of 0 is in one of these
/// two.
inline constexpr std::array histogramEnds = {0.0, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3};

struct DifferenceHistogram {
    std::array<std::int64_t, histogramEnds.size() + 1> counts{};
    std::int64_t notFinite = 0;  ///< values of which one is no number
    std::int64_t marginal = 0;   ///< values that a truth leaves open, in no bin
};

/// All values of all channels. Nothing is counted of images that cannot be compared.
[[nodiscard]] DifferenceHistogram differenceHistogram(const image::Image& expected,
                                                      const image::Image& actual, const CompareRules& rules);

}  // namespace raytorus::compare
