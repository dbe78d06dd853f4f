// SPDX-License-Identifier: MIT
// Texts of options that several commands have. What is wrong with one is an Error{Usage}.
#pragma once

#include <string>
#include <utility>

#include "reference/rays.hpp"

namespace raytorus::cli {

/// --size: "960x640".
std::pair<int, int> sizeOption(const std::string& text);

/// --replay: ten numbers, as raytorus-verify prints them.
reference::TorusAndRay replayOption(const std::string& text);

}  // namespace raytorus::cli
