// SPDX-License-Identifier: MIT
// Commands that people paste: their words, as a POSIX shell reads them.
#pragma once

#include <string>
#include <string_view>

namespace raytorus {

/// The text as one word of a POSIX shell: as it is where it is plain, in single quotes where the shell would
/// see more in it.
[[nodiscard]] std::string shellQuote(std::string_view word);

}  // namespace raytorus
