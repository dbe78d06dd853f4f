// SPDX-License-Identifier: MIT
// The results as text.
#pragma once

#include <string>

#include "bench/result.hpp"

namespace raytorus::bench {

/// The methods of a cell, a row each, under a line that says what they were asked.
std::string tableText(const CellResult& cell);

/// "0.62", "-" where there is none.
std::string ratioText(double ratio);

}  // namespace raytorus::bench
