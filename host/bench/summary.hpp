// SPDX-License-Identifier: MIT
// What all cells of a run say together.
#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"

namespace raytorus::bench {

/// How steady the ratios were: on a busy machine minima count and quartiles do not.
std::string steadinessText(const BenchRun& run);

/// Ours over its, each method a row, the geometric mean over the workloads of a pattern and query a column;
/// and how much it was wrong over all. Streamed workloads are left out.
std::string summaryText(const BenchRun& run);

/// What the library aims at: how its time is to compare.
struct Aim {
    std::string text;
    double limit = 0.0;            ///< ours over its, at most
    std::vector<double> measured;  ///< of each cell that it is about
    double worst = 0.0;
    std::string worstWorkload;
};

/// Those that the run has cells for.
std::vector<Aim> measureAims(const BenchRun& run);

/// A row each: the limit, the geometric mean, the worst, and in how many cells it is held.
std::string aimsText(const std::vector<Aim>& aims);

/// A sentence for each cell in which the library was wrong on a ray, or two of its runs differed.
std::vector<std::string> libraryFaults(const BenchRun& run);

/// 0 if there are none.
double geometricMean(const std::vector<double>& values);

/// The method's row, or null.
const MethodResult* findMethod(const CellResult& cell, std::string_view name);

}  // namespace raytorus::bench
