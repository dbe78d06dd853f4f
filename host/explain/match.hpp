// SPDX-License-Identifier: MIT
// Which answer belongs to which root where one side has fewer.
#pragma once

#include <vector>

#include "reference/real.hpp"

namespace raytorus::explain {

/// For each entry of the shorter list its place in the longer one: both ascend and so do the places, and the
/// sum of the differences is the smallest. For lists of a few entries.
std::vector<std::size_t> matched(const std::vector<reference::Quad>& shorter,
                                 const std::vector<reference::Quad>& longer);

}  // namespace raytorus::explain
