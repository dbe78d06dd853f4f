// SPDX-License-Identifier: MIT
// Who can draw: the library and the methods it is compared with, and the shaders that are being edited.
#pragma once

#include <string>
#include <vector>

#include "trace/shader_source.hpp"

namespace raytorus::viewer {

struct MethodEntry {
    std::string name;
    std::string description;
    trace::ShaderSource shaders;
    trace::ShaderSource steps;  ///< the same pictures with steps counted, where the method counts any
    bool edited = false;        ///< the shaders that are being edited
    int version = 0;            ///< changes with the shaders
};

/// methods(), in their order. withEdited: then "edited", which is the library until it has been compiled.
std::vector<MethodEntry> methodList(bool withEdited);

/// Gives the entry other shaders.
void replaceShaders(MethodEntry& entry, const trace::ShaderSource& shaders, const trace::ShaderSource& steps);

/// The place of a method in the list. Throws Error{Usage} if there is none of that name.
std::size_t indexOf(const std::vector<MethodEntry>& methods, const std::string& name);

}  // namespace raytorus::viewer
