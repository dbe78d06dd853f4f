// SPDX-License-Identifier: MIT
#include "cli/command.hpp"
#include "cli/program.hpp"

int main(int argc, char** argv) {
    return raytorus::cli::exitStatus(raytorus::cli::runCommandLine({argv + 1, argv + argc}));
}
