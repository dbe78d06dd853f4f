// SPDX-License-Identifier: MIT
#include "core/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace raytorus {
namespace {

// Letters to be put in, left out or exchanged (Levenshtein).
std::size_t editDistance(std::string_view a, std::string_view b) {
    // The distances of a's first i letters from each beginning of b.
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0U : 1U);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string> known) {
    const auto distance = [word](std::string_view other) { return editDistance(word, other); };
    const auto nearest = std::ranges::min_element(known, {}, distance);
    // A third of the letters may be wrong: one of "sky", two of "gold", which two swapped letters are.
    if (nearest == known.end() || distance(*nearest) > (nearest->size() + 2) / 3) {
        return "";
    }
    return fmt::format("; did you mean {}?", *nearest);
}

}  // namespace raytorus
