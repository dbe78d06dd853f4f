// SPDX-License-Identifier: MIT
// How often words stand in a text.
#pragma once

#include <cstddef>
#include <string>

namespace raytorus::test {

/// Those that overlap, too.
inline std::size_t countOf(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

}  // namespace raytorus::test
