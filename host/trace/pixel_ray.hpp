// SPDX-License-Identifier: MIT
// The ray that the shaders send through a pixel, in their own float32 steps, so bit for bit on devices that
// round as IEEE 754 says: for taking a pixel apart.
#pragma once

#include "scene_io.h"
#include "trace/hits.hpp"

namespace raytorus::trace {

/// In the world, through the middle of the pixel; from 0 to infinity. Pixels count from the upper left
/// corner.
TraceRay cameraRay(const scene_io::SceneFrame& frame, int x, int y);

/// The same in the frame of a torus, where the library meets it.
TraceRay rayInFrame(const scene_io::SceneTorus& torus, const TraceRay& ray);

}  // namespace raytorus::trace
