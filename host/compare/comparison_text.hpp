// SPDX-License-Identifier: MIT
// A comparison in words: one sentence, a table for people, JSON for programs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compare/compare.hpp"

namespace raytorus::compare {

/// "identical", "agree", "differ", "size differs" or "non-finite".
[[nodiscard]] std::string verdictName(Verdict verdict);

/// A float as short as it can be and still come back exactly; "NaN", "+Inf", "-Inf" for what is no number.
[[nodiscard]] std::string valueText(float value);

/// "(x, y)".
[[nodiscard]] std::string pixelText(Pixel pixel);

/// The sentence for Comparison::sentence, from everything else in it.
[[nodiscard]] std::string verdictSentence(const Comparison& comparison, const image::Image& expected,
                                          const image::Image& actual);

/// The numbers of one channel, as text: the cells of a table.
using NumberRow = std::array<std::string, 12>;

/// A row of headings, then a row for each channel.
[[nodiscard]] std::vector<NumberRow> numberRows(const Comparison& comparison);

/// What is counted over all channels, in one line.
[[nodiscard]] std::string countsLine(const Comparison& comparison);

/// Against a truth, a line for each of its margins and one for all of them; else none.
[[nodiscard]] std::vector<std::string> marginLines(const Comparison& comparison);

/// The numbers as lines of aligned columns, each ending in a newline. Empty when the images were not
/// compared.
[[nodiscard]] std::string numbersTable(const Comparison& comparison);

/// All of it as one JSON object, indented.
[[nodiscard]] std::string jsonText(const Comparison& comparison);

}  // namespace raytorus::compare
