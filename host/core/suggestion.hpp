// SPDX-License-Identifier: MIT
// The word that was meant by one that is misspelt.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raytorus {

/// "; did you mean majorRadius?" of the known word that is nearest to this one, or nothing where none is
/// near.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace raytorus
