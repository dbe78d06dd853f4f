// SPDX-License-Identifier: MIT
// An explanation for programs. docs/cli.md lists the keys.
#pragma once

#include <string>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// One object, indented, without a line break at its end.
std::string jsonOf(const Explanation& explanation);

}  // namespace raytorus::explain
