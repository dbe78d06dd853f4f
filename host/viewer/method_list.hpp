// SPDX-License-Identifier: MIT
// Who can draw: the library and the methods it is compared with, and the shaders that are being edited.
#pragma once

#include <string>
#include <vector>

#include "render/shader_source.hpp"

namespace raytorus::viewer {

struct MethodEntry {
    std::string name;
    std::string description;
    render::ShaderSource shaders;
    render::ShaderSource
        steps;  ///< the same pictures, and the number of steps in the fourth channel of surface
    bool countsSteps = false;  ///< else `steps` is `shaders`, and all are 0
    int version = 0;           ///< changes with the shaders; no two entries ever have the same
};

/// methods(), in their order.
std::vector<MethodEntry> builtInMethods();

/// The place of a method in the list. Throws Error{Usage} if there is none of that name.
std::size_t indexOf(const std::vector<MethodEntry>& methods, const std::string& name);

}  // namespace raytorus::viewer
