// SPDX-License-Identifier: MIT
// report.css and report.js, as they stand in this folder.
#pragma once

#include <string_view>

namespace raytorus::report {

extern const std::string_view styleSheet;
extern const std::string_view script;

}  // namespace raytorus::report
