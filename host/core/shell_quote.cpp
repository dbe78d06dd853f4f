// SPDX-License-Identifier: MIT
#include "core/shell_quote.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/console.hpp"

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
    return replaceHidden(quoted + "'", [](std::string_view bytes) {
        std::string octal;
        for (const char byte : bytes) {
            octal += fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
        }
        return "'\"$(printf '" + octal + "')\"'";
    });
}

std::string shellOption(std::string_view name, std::string_view value) {
    // By itself a value that begins with '-' would be taken for an option.
    return fmt::format(" {}{}{}", name, value.starts_with('-') ? '=' : ' ', shellQuote(value));
}

}  // namespace raytorus
