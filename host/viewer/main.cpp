// SPDX-License-Identifier: MIT
// raytorus-view: a window onto a scene of tori.
#include "options/program.hpp"
#include "viewer/viewer.hpp"

int main(int argc, char** argv) {
    using namespace raytorus;
    return options::exitStatus(options::runProgram(viewer::programName, [&] {
        if (const auto options = viewer::parseOptions({argv + 1, argv + argc})) {
            viewer::runViewer(*options);
        }
        return ExitCode::Ok;
    }));
}
