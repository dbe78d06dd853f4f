// SPDX-License-Identifier: MIT
// How far a misspelt word is from one that is known.
#pragma once

#include <cstddef>
#include <string_view>

namespace raytorus {

/// Letters to be put in, left out or exchanged (Levenshtein).
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

}  // namespace raytorus
