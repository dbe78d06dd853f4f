// SPDX-License-Identifier: MIT
// JSON text to a tree, more strictly than the library's own parser: a key given twice, a number that float32
// cannot hold and excessive nesting are errors with their JSON pointer; syntax errors have line and column.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace raytorus {

/// Keys keep the order of the file.
using Json = nlohmann::ordered_json;

/// A key as a part of a JSON pointer, with its slash: "/majorRadius".
std::string pointerPart(std::string_view key);

/// A value as a message names it: itself if it is short, else its kind ("an object", "an array of 9").
std::string describe(const Json& value);

/// Throws Error with ExitCode::Scene and "source: pointer: fault", or "source: fault" if the pointer is
/// empty.
[[noreturn]] void failAt(std::string_view sourceName, const std::string& pointer, const std::string& fault);

/// Throws as failAt.
Json parseStrictJson(std::string_view text, std::string_view sourceName);

}  // namespace raytorus
