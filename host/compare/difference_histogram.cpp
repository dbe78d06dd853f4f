// SPDX-License-Identifier: MIT
#include "compare/difference_histogram.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "compare/channel_judge.hpp"

namespace raytorus::compare {

namespace {

std::size_t binOf(double difference, double limit) {
    double ratio = 0.0;
    if (difference > 0.0) {
        ratio = limit > 0.0 ? difference / limit : std::numeric_limits<double>::infinity();
    }
    const auto* const end = std::ranges::lower_bound(histogramEnds, ratio);
    return static_cast<std::size_t>(end - histogramEnds.begin());
}

}  // namespace

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
