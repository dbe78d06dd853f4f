// SPDX-License-Identifier: MIT
// An explanation as a picture, self-contained: the section of the torus by the plane of the ray and the
// centre, and beside it the reduced quartic. Both count t' of the reduced ray (docs/math.md) from left to
// right, to one scale.
#pragma once

#include <string>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// A hit has a mark of class "hit" in each of the two parts; "missed" and "invented" are the wrong ones,
/// "root" the rest.
std::string svgOf(const Explanation& explanation);

}  // namespace raytorus::explain
