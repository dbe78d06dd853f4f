// SPDX-License-Identifier: MIT
// The commands of the raytorus program. Each adds its options to the application and, when the user chose it,
// leaves what is to be run in `action`.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace raytorus::cli {

using Action = std::function<ExitCode()>;

void addRenderCommand(CLI::App& app, Action& action);
void addTraceCommand(CLI::App& app, Action& action);
void addCompareCommand(CLI::App& app, Action& action);
void addExplainCommand(CLI::App& app, Action& action);
void addGoldenCommand(CLI::App& app, Action& action);
void addDoctorCommand(CLI::App& app, Action& action);

/// Parses and runs a command line (without the program's name), as runProgram does.
ExitCode runCommandLine(const std::vector<std::string>& arguments);

}  // namespace raytorus::cli
