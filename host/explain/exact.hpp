// SPDX-License-Identifier: MIT
// The derivation of docs/math.md in 113 bits, and every real root of a line's quartic.
#pragma once

#include <vector>

#include "explain/explanation.hpp"

namespace raytorus::explain {

/// Of valid input; `reduced` is false for R = 0, where there is nothing to scale to 1.
Steps<Quad> exactSteps(const reference::Torus& torus, const reference::Ray& ray);

/// Both sheets of a spindle, on the whole line, ascending. `hit` and `closedForm` are left open.
std::vector<TrueRoot> trueRoots(const reference::Torus& torus, const reference::Ray& ray,
                                const Steps<Quad>& steps);

}  // namespace raytorus::explain
