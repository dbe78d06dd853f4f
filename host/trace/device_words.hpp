// SPDX-License-Identifier: MIT
// The device of a run, in a command that does the same again.
#pragma once

#include <string>

#include "gpu/context.hpp"

namespace raytorus::trace {

/// " --device NAME --timeout 5": the options that differ from what they are unless given, quoted for a shell.
[[nodiscard]] std::string deviceWords(const gpu::ContextOptions& options, const std::string& shaderFolder);

}  // namespace raytorus::trace
