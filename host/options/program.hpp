// SPDX-License-Identifier: MIT
// What every program of raytorus does around its work.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace raytorus::options {

/// Runs a program's work. The one place where an Error becomes an exit code: its sentence goes to standard
/// error, after the program's name.
ExitCode runProgram(std::string_view name, const std::function<ExitCode()>& work);

/// What the command line has and the program, or its command, knows nothing of: "there is no option --sise;
/// did you mean --size?", a command, or one argument too many. Behind "--" there are names alone. Empty if
/// there is no such thing.
std::string unexpected(const CLI::App& app, const std::vector<std::string>& arguments);

/// "a command is missing: list, check", where one must follow; else empty.
std::string missingCommand(const CLI::App& app);

/// Throws Error{Usage} where an option or an argument is given as an empty word: a variable of a script that
/// is not set must not leave an output unwritten.
void refuseEmptyWords(const CLI::App& app);

/// Reads the command line of a program that has no commands. False where --help or --version has been
/// answered and nothing is left to do. Throws Error{Usage}.
bool parse(CLI::App& app, const std::vector<std::string>& arguments);

/// What main returns. Never returns itself where the driver may still be at work on what it did not finish in
/// time: that process leaves without tearing the driver down.
int exitStatus(ExitCode code);

}  // namespace raytorus::options
