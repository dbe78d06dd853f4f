// SPDX-License-Identifier: MIT
#include "bench/timing.hpp"

#include <algorithm>
#include <cmath>

namespace raytorus::bench {
namespace {

// How close another run has to come to confirm one: the fastest of nine differ by some hundredths.
constexpr double confirmedWithin = 1.1;

double ratioOf(double ours, double its) {
    return ours > 0.0 && its > 0.0 ? ours / its : 0.0;
}

}  // namespace

std::vector<Series> takeTurns(const std::vector<std::function<Shot()>>& contestants, unsigned rounds) {
    std::vector<Series> series(contestants.size());
    std::vector<std::uint32_t> checksums;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        const Shot first = contestants[i]();
        checksums.push_back(first.checksum);
        series[i].checksumHeld = first.layersAgree;
    }
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
            const std::size_t i = (round + turn) % contestants.size();
            const Shot shot = contestants[i]();
            series[i].nanoseconds.push_back(1e9 * shot.seconds / shot.rays);
            const bool held = shot.layersAgree && shot.checksum == checksums[i];
            series[i].checksumHeld = series[i].checksumHeld && held;
        }
    }
    return series;
}

double confirmedMinimum(std::vector<double> values) {
    std::ranges::sort(values);
    const auto found = std::ranges::adjacent_find(
        values, [](double faster, double slower) { return slower <= confirmedWithin * faster; });
    return found != values.end() ? *found : quantile(values, 0.5);
}

Times timesOf(const Series& its, const Series& ours, const Series* empty) {
    const auto minimumOf = [](const Series& series) { return confirmedMinimum(series.nanoseconds); };
    const double idle = empty != nullptr ? minimumOf(*empty) : 0.0;
    Times times;
    times.minimum = minimumOf(its);
    times.median = quantile(its.nanoseconds, 0.5);
    times.netMinimum = times.minimum - idle;
    times.ratio = ratioOf(minimumOf(ours) - idle, times.netMinimum);
    std::vector<double> ratios;
    for (std::size_t round = 0; round < its.nanoseconds.size(); ++round) {
        const double idleNow = empty != nullptr ? empty->nanoseconds[round] : 0.0;
        const double ratio = ratioOf(ours.nanoseconds[round] - idleNow, its.nanoseconds[round] - idleNow);
        if (ratio > 0.0) {
            ratios.push_back(ratio);
        }
    }
    times.lowerQuartile = quantile(ratios, 0.25);
    times.middleRatio = quantile(ratios, 0.5);
    times.upperQuartile = quantile(ratios, 0.75);
    return times;
}

double quantile(std::vector<double> values, double part) {
    if (values.empty()) {
        return 0.0;
    }
    std::ranges::sort(values);
    const double at = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace raytorus::bench
