// SPDX-License-Identifier: MIT
// A ray through the scene and what it sees, exactly: the definition of a picture's values.
#pragma once

#include "truth/shading.hpp"

namespace raytorus::truth {

/// All crossings of one torus by a ray in its frame, reduced in 104 bits and solved in doubles: right to
/// 1e-10 of its size where the ray is not as good as tangent, at any distance, and a hundred times as fast.
reference::BasicIntersections<double> quickCrossings(const scene_io::SceneTorus& torus,
                                                     const SceneRay<DoubleDouble>& local);

/// What one ray through the picture sees. Surface: the type of what is computed after the hit.
template <class Surface>
struct Sample {
    int torus = -1;
    int count = 0;
    Surface t{};
    SurfacePoint<Surface> point{};
    Vec3<Surface> color{};
    bool otherField = false;
    LightMask reaching;  ///< lights that no torus hides; a light behind the surface counts as one
};

/// Hits in Real, all else in Surface: Quad and Quad for the truth, DoubleDouble and double to question it.
template <class Real, class Surface>
Sample<Surface> traceSample(const SceneData& scene, const SceneRay<Real>& ray);

}  // namespace raytorus::truth
