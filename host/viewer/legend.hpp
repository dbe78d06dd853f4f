// SPDX-License-Identifier: MIT
// What the colours of a view mean, beside the picture.
#pragma once

#include "viewer/state.hpp"

namespace raytorus::viewer {

/// Draws the legend of the view into the panel that is being made; nothing for views that need none.
void drawLegend(const State& state);

}  // namespace raytorus::viewer
