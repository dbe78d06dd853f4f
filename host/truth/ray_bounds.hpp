// SPDX-License-Identifier: MIT
// How far a shader's ray may lie from the exact one, when every operation rounds to the nearest float.
//
// The direction forward + x right + y up is off by the error vector d of its components (Rounded); the part
// of d along the direction changes its length alone, so d turns it by at most |d| / length. Dividing by the
// length does not turn it, but for the rounding of the quotients: half an ulp of each component, together at
// most 2^-24. The unit vector's length is off by that of the square root of the sum of squares, and by those
// quotients' rounding.
//
// In the torus' frame the origin is off by the rounding of (origin - centre) and of its rotation, the
// direction by the rounding of its rotation. What the library itself adds, 9e-8 (R + r), is the bound of
// docs/accuracy.md.
#pragma once

#include "reference/promise.hpp"
#include "truth/scene_data.hpp"

namespace raytorus::truth {

using reference::positionBound;

/// How far from the surface an end of a ray has to be for the library to know on which side it is.
double libraryEnd(const scene_io::SceneTorus& torus);

struct CameraBounds {
    double turned = 0.0;     ///< how far the direction may be turned, in radians
    double stretched = 0.0;  ///< how far its length may be from 1
};
CameraBounds cameraBounds(const scene_io::SceneFrame& frame, const PicturePoint<Rounded>& point);

/// A ray's displacement: how far, at t, it may lie from the exact ray.
struct Displacement {
    double origin = 0.0;
    double perT = 0.0;

    [[nodiscard]] double at(double t) const { return origin + t * perT; }
};
/// In the frame of a torus, for a ray with these errors.
Displacement displacementAt(const scene_io::SceneTorus& torus, const SceneRay<Rounded>& ray);

}  // namespace raytorus::truth
