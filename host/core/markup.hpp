// SPDX-License-Identifier: MIT
// Words in pages, drawings and other XML.
#pragma once

#include <string>
#include <string_view>

namespace raytorus {

/// The text as HTML, SVG and XML can hold it, in an attribute too: printable, and nothing in it is markup.
[[nodiscard]] std::string escapeHtml(std::string_view text);

}  // namespace raytorus
