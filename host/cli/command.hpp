// SPDX-License-Identifier: MIT
// The commands of the raytorus program. Each adds its options to the application and, when the user chose it,
// leaves what is to be run in `action`; main runs it and turns Error into an exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "core/error.hpp"

namespace raytorus::cli {

using Action = std::function<ExitCode()>;

void addRenderCommand(CLI::App& app, Action& action);
void addTraceCommand(CLI::App& app, Action& action);
void addCompareCommand(CLI::App& app, Action& action);
void addDoctorCommand(CLI::App& app, Action& action);

}  // namespace raytorus::cli
