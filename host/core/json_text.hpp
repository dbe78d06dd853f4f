// SPDX-License-Identifier: MIT
// JSON that is written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace raytorus {

/// The tree as text, valid whatever its strings hold: what is no UTF-8 becomes U+FFFD, and what may not be
/// shown (core/console.hpp) an escape, so that the text can be printed as it is. Indented, or one line for
/// -1.
[[nodiscard]] std::string dumpJson(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace raytorus
