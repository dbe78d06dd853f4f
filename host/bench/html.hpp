// SPDX-License-Identifier: MIT
// The results as a page: one file, nothing loaded, light and dark.
#pragma once

#include <string>

#include "bench/result.hpp"

namespace raytorus::bench {

std::string runHtml(const BenchRun& run);

}  // namespace raytorus::bench
