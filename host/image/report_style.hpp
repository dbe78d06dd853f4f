// SPDX-License-Identifier: MIT
// The style sheet and script of a report.
#pragma once

#include <string_view>

namespace raytorus::image {

[[nodiscard]] std::string_view reportStyle();
[[nodiscard]] std::string_view reportScript();

}  // namespace raytorus::image
