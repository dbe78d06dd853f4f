// SPDX-License-Identifier: MIT
// What a report looks like and how it reacts: its style sheet and script, put into the page itself.
#pragma once

#include <string_view>

namespace raytorus::image {

[[nodiscard]] std::string_view reportStyle();
[[nodiscard]] std::string_view reportScript();

}  // namespace raytorus::image
