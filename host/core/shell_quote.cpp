// SPDX-License-Identifier: MIT
#include "core/shell_quote.hpp"

#include <algorithm>

namespace raytorus {
namespace {

bool isPlain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
}

}  // namespace

std::string shellQuote(std::string_view word) {
    if (!word.empty() && std::ranges::all_of(word, isPlain)) {
        return std::string(word);
    }
    std::string quoted = "'";
    for (const char c : word) {
        // Nothing ends the quotes but a quote, and there is no way to write one inside them.
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

}  // namespace raytorus
