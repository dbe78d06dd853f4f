// SPDX-License-Identifier: MIT
// The viewer itself: from what happens to what is shown, frame by frame.
#pragma once

#include "viewer/viewer_options.hpp"

namespace raytorus::viewer {

/// Opens the window and returns when it is closed. Throws Error.
void runViewer(const ViewerOptions& options);

}  // namespace raytorus::viewer
