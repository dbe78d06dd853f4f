// SPDX-License-Identifier: MIT
// The panel: everything that can be changed, and the numbers of what is shown.
#pragma once

#include <string>
#include <vector>

#include "viewer/method_list.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

struct PanelInfo {
    const std::vector<MethodEntry>* methods = nullptr;
    std::string device;  ///< its name and driver
    bool animated = false;
};

/// Changes the state as the user says.
void drawPanel(State& state, const PanelInfo& info);

/// The part with tori, materials, lights and camera.
void drawScenePanel(State& state);

}  // namespace raytorus::viewer
