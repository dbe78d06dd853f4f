// SPDX-License-Identifier: MIT
// How sharp a sample is: how far from flipping its verdicts are, and how far a correct float32 shader's
// values may be from the exact ones. docs/golden.md explains what the numbers mean; the derivation stands
// beside each step.
#pragma once

#include "truth/ray_bounds.hpp"
#include "truth/sample.hpp"

namespace raytorus::truth {

/// Margins in displacements: 1 means that a ray displaced as far as a shader's may be could just flip the
/// verdict. Tolerances are absolute.
struct Sharpness {
    double margin = 0.0, marginCount = 0.0,
           marginColor = 0.0;  ///< of nearest hit, number of surfaces, colour
    double color = 0.0, t = 0.0, position = 0.0, normal = 0.0, uv = 0.0;  ///< tolerances
};

/// What the truth says of the sample; only discrete facts and t, in double.
struct Seen {
    int torus = -1;
    double t = 0.0;
    bool otherField = false;
    LightMask reaching;
};

Sharpness sharpnessOf(const SceneData& scene, const PicturePoint<Rounded>& at,
                      const SceneRay<DoubleDouble>& ray, const Seen& seen);

}  // namespace raytorus::truth
