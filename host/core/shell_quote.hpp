// SPDX-License-Identifier: MIT
// Commands that people paste: their words, as a POSIX shell reads them.
#pragma once

#include <string>
#include <string_view>

namespace raytorus {

/// The text as one word of a POSIX shell: as it is where it is plain, in single quotes where the shell would
/// see more in it. What may not be shown is made by printf, so that the command can be shown, and copied.
[[nodiscard]] std::string shellQuote(std::string_view word);

/// " --name value".
[[nodiscard]] std::string shellOption(std::string_view name, std::string_view value);

}  // namespace raytorus
