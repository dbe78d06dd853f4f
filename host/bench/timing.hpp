// SPDX-License-Identifier: MIT
// Runs taken in turns, and what is made of their times.
#pragma once

#include <functional>
#include <vector>

#include "bench/kernel.hpp"

namespace raytorus::bench {

/// What the runs of one contestant were.
struct Series {
    std::vector<double> nanoseconds;  ///< a ray, by round
    bool checksumHeld = true;         ///< every run's checksum was that of the first, and its layers agreed
};

/// Runs every contestant once a round, for so many rounds, each round beginning with the next one: A B C, B C
/// A, C A B, ... so that no one always comes after the same other. Before, each runs once untimed: drivers
/// compile then; that run's checksum is the one that the others have to have.
std::vector<Series> takeTurns(const std::vector<std::function<Shot()>>& contestants, unsigned rounds);

/// The least value to which another comes within a tenth; the median if there is none. Processor time under a
/// hypervisor needs it: the kernel takes off in one lump what other machines have stolen, at the wrong time,
/// and a run comes out at a twentieth of what it took.
double confirmedMinimum(std::vector<double> values);

/// Times of one contestant, in nanoseconds a ray. Net: less what the empty one took, in the same round.
struct Times {
    double minimum = 0.0;  ///< confirmedMinimum
    double median = 0.0;
    double netMinimum = 0.0;  ///< the minimum less the empty one's minimum
    /// Ours over its, net: of the minima, and the quartiles of those of each round. 0 where a net time is not
    /// positive, so that there is none.
    double ratio = 0.0;
    double lowerQuartile = 0.0;
    double middleRatio = 0.0;
    double upperQuartile = 0.0;
};

/// `empty` may be null: then nothing is taken off.
Times timesOf(const Series& its, const Series& ours, const Series* empty);

/// Of values in any order, linearly between two of them; `part` from 0 to 1. 0 if there are none.
double quantile(std::vector<double> values, double part);

}  // namespace raytorus::bench
