// SPDX-License-Identifier: MIT
// What every program of raytorus does around its work.
#pragma once

#include <functional>
#include <string_view>

#include "core/error.hpp"

namespace raytorus::cli {

/// Runs a program's work. The one place where an Error becomes an exit code: its sentence goes to standard
/// error, after the program's name.
ExitCode runProgram(std::string_view name, const std::function<ExitCode()>& work);

/// What main returns. Never returns itself where the driver may still be at work on what it did not finish in
/// time: that process leaves without tearing the driver down.
int exitStatus(ExitCode code);

}  // namespace raytorus::cli
