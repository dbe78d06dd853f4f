// SPDX-License-Identifier: MIT
// What the programs say, on standard output and standard error.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace raytorus {

/// Whether all of it is well formed.
bool isUtf8(std::string_view text);

/// What stands in the place of a character, or of a byte that is no UTF-8.
using Replacement = std::function<std::string(std::string_view bytes)>;

/// The text with all replaced that may not be shown, as printable() tells.
std::string replaceHidden(std::string_view text, const Replacement& instead);

/// The text as it may be shown: a terminal obeys some characters, and turns the direction of what follows
/// others. Those, and noncharacters, become \u001b, and bytes that are no UTF-8 become \xff. Tabs and ends of
/// lines stay.
std::string printable(std::string_view text);

/// What a file or a command line holds, for a message: printable on one line, and cut after `most` bytes.
std::string excerpt(std::string_view text, std::size_t most = 200);

/// To standard output, made printable. Throws Error{File} if it cannot be written.
void writeOutput(std::string_view text);

/// What was written so far is there. Throws Error{File} if it is not.
void flushOutput();

/// To standard error, made printable. Where that cannot be written, nobody can be told.
void writeError(std::string_view text) noexcept;

template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    writeOutput(fmt::format(format, std::forward<Arguments>(arguments)...));
}

}  // namespace raytorus
