// SPDX-License-Identifier: MIT
// A run of the benchmark made up for tests of what is written of it.
#pragma once

#include "bench/result.hpp"

namespace raytorus::test {

/// Tiles and scattered rays at r/R = .25, near, 30 %, each asked for nearest and any. The methods: empty,
/// raytorus, closed-form-common at the ratio `ratio` to ours, with quartiles 2 % to each side, and
/// ray-sphere, wrong on a tenth of its rays.
bench::BenchRun madeUpRun(double ratio);

}  // namespace raytorus::test
