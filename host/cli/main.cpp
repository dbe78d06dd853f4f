// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>

#include "cli/command.hpp"

int main(int argc, char** argv) {
    using raytorus::ExitCode;
    const ExitCode code = raytorus::cli::runCommandLine({argv + 1, argv + argc});
    if (code == ExitCode::DeviceLost) {
        // The driver may still be at work on what it did not finish in time: leave without tearing it down.
        std::fflush(nullptr);
        std::_Exit(static_cast<int>(code));
    }
    return static_cast<int>(code);
}
