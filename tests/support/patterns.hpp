// SPDX-License-Identifier: MIT
// Regular expressions in ECMAScript's grammar, compiled once: a file that includes <regex> takes seconds for
// that alone.
#pragma once

#include <string>
#include <vector>

namespace raytorus::test {

/// One match: the whole of it, then its groups; one that took no part is empty.
using PatternMatch = std::vector<std::string>;

/// All matches from left to right, none over another.
std::vector<PatternMatch> matchesIn(const std::string& text, const std::string& pattern);

/// Whether the text as a whole is as the pattern says.
bool isLike(const std::string& text, const std::string& pattern);

}  // namespace raytorus::test
