// SPDX-License-Identifier: MIT
// How far the verdicts on a camera ray are from flipping: which surface it hits first, and how many it
// crosses.
#pragma once

#include "truth/clearance.hpp"
#include "truth/ray_bounds.hpp"

namespace raytorus::truth {

struct VerdictMargins {
    double nearest, count;
};

/// In units of what the ray may be displaced at most. torus, t: the nearest hit, or -1 and anything.
VerdictMargins verdictMargins(const SceneData& scene, const SceneRay<DoubleDouble>& ray,
                              const CameraBounds& camera, int torus, double t);

/// What becoming a ray in a torus' frame does to a ray.
Displacement frameDisplacement(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& ray);

/// How far a camera ray may lie from the exact one at t, in a torus' frame.
Displacement cameraDisplacement(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& ray,
                                const CameraBounds& camera);

}  // namespace raytorus::truth
