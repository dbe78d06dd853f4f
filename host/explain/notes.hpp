// SPDX-License-Identifier: MIT
// What is wrong with a ray and torus, and what is special about them.
#pragma once

#include <string>
#include <vector>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// Why the contract of torus.glsl promises no hit, whatever else the numbers say. Nothing for a proper ray.
std::vector<std::string> faultsOf(const reference::Torus& torus, const reference::Ray& ray);

/// Special positions, decided exactly. Of an explanation without faults that has its clearances.
std::vector<std::string> notesOf(const Explanation& explanation);

}  // namespace raytorus::explain
