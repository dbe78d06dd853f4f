// SPDX-License-Identifier: MIT
// A run beside an earlier one: what changed in the ratios. Times themselves are the machine's mood, ratios of
// runs taken in turns are not.
#pragma once

#include <string>
#include <vector>

#include "bench/json.hpp"
#include "bench/result.hpp"

namespace raytorus::bench {

struct Change {
    std::string workload;
    std::string query;
    std::string method;
    double before = 1.0;  ///< ours over its, of the minima
    double now = 1.0;
    /// By more than runToRun, and the quartiles of then and now, widened by as much, do not meet: on a busy
    /// machine quartiles wander and minima stay, on a quiet one both stay.
    bool leftSpread = false;
    bool otherRays = false;    ///< another number of them: pixels lie closer, or further apart
    bool becameWrong = false;  ///< of the library alone: it was right on all rays, and is no more

    [[nodiscard]] double factor() const { return now / before; }
};

/// By how much ratios of the same program differ from run to run, whatever their quartiles say: seeds, and
/// where the driver put the code.
inline constexpr double runToRun = 0.05;

/// Every method of every cell that both have, but for the empty one; the library only where it became wrong.
std::vector<Change> compareWith(const ReferenceTable& reference, const BenchRun& run);

/// What left the spread, the greatest change first; then the mean change of each method.
std::string againstText(const ReferenceTable& reference, const BenchRun& run);

}  // namespace raytorus::bench
