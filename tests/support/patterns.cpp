// SPDX-License-Identifier: MIT
#include "patterns.hpp"

#include <regex>

namespace raytorus::test {

std::vector<PatternMatch> matchesIn(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<PatternMatch> matches;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
        matches.emplace_back(match->begin(), match->end());
    }
    return matches;
}

bool isLike(const std::string& text, const std::string& pattern) {
    return std::regex_match(text, std::regex(pattern));
}

}  // namespace raytorus::test
