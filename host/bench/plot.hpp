// SPDX-License-Identifier: MIT
// The results as a drawing: SVG, which needs nothing else.
#pragma once

#include <string>

#include "bench/result.hpp"

namespace raytorus::bench {

/// One query: a row a method, and on it, for tiles and for scattered rays, a mark for each workload at its
/// time over the library's (logarithmic), a line at the geometric mean, and that as a number. Crosses are
/// workloads on which more than one answer in a thousand was wrong. Colours follow the page's custom
/// properties (html.cpp).
std::string ratioPlot(const BenchRun& run, trace::Query query);

}  // namespace raytorus::bench
