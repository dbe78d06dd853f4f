// SPDX-License-Identifier: MIT
// An explanation to read.
#pragma once

#include <string>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// Sections of aligned columns, the conclusion last; ends with a line break.
std::string textOf(const Explanation& explanation);

}  // namespace raytorus::explain
