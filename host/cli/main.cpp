// SPDX-License-Identifier: MIT
#include "cli/command.hpp"
#include "options/program.hpp"

int main(int argc, char** argv) {
    return raytorus::options::exitStatus(raytorus::cli::runCommandLine({argv + 1, argv + argc}));
}
