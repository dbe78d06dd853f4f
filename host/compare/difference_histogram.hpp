// SPDX-License-Identifier: MIT
// How far off the values of an image are, counted by size.
#pragma once

#include <array>
#include <cstdint>

#include "compare/compare_rules.hpp"
#include "image/image.hpp"

namespace raytorus::compare {

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
