// SPDX-License-Identifier: MIT
// The preprocessor directives of one file, without the files around it: enough to tell what glslang does not,
// where an #if that is never closed was opened, and whether a file may include itself without end.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::compile {

struct Directive {
    int line;             ///< from 1
    std::string keyword;  ///< "ifdef"; empty for a lone #
    std::string rest;     ///< what follows, without comments and spaces around it
};

/// All directives, of skipped parts too.
[[nodiscard]] std::vector<Directive> findDirectives(std::string_view text);

/// The innermost #if, #ifdef or #ifndef that the file leaves open.
[[nodiscard]] std::optional<Directive> unclosedConditional(const std::vector<Directive>& directives);

/// The file begins with #ifndef NAME, #define NAME (or #if !defined NAME, with or without parentheses), and
/// has no directives after the #endif that belongs to it.
[[nodiscard]] bool hasIncludeGuard(const std::vector<Directive>& directives);

}  // namespace raytorus::compile
