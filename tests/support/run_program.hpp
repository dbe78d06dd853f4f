// SPDX-License-Identifier: MIT
// Runs a program as users do: a process of its own, no shell, and what it said and how it ended.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace raytorus::test {

/// Variables that the program sees besides, or instead of, those of the tests.
using Environment = std::map<std::string, std::string>;

struct ProgramSettings {
    std::filesystem::path folder;  ///< where the program runs; empty: where the tests do
    Environment environment;
    std::chrono::seconds timeLimit{120};  ///< then it is killed
};

struct ProgramResult {
    int exitCode = -1;           ///< minus the signal's number if a signal ended it
    std::string out;             ///< standard output
    std::string err;             ///< standard error
    std::size_t peakMemory = 0;  ///< bytes of its largest resident set
};

/// Runs the program with these arguments until it ends. Throws std::system_error if it cannot be started.
ProgramResult runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const ProgramSettings& settings = {});

/// For GoogleTest.
void PrintTo(const ProgramResult& result, std::ostream* stream);

}  // namespace raytorus::test
