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

/// An extremum of the distance to the tube nearer to the surface than this, in r, makes a ray nearly tangent:
/// what raytorus-verify, too, judges apart.
inline constexpr double nearlyTangent = 1e-3;

/// An end of the ray nearer to the surface than this, in r, leaves the hit there open: thrice the rounding of
/// the distance itself, as raytorus-verify judges ends.
double endMargin(const reference::Torus& torus);

}  // namespace raytorus::explain
