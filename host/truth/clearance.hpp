// SPDX-License-Identifier: MIT
// How far a ray passes from a torus: the signed distance to the tube, f = sqrt((rho - R)^2 + z^2) - r, along
// a line. f is 1-Lipschitz: a line displaced by e has an f that differs by at most e everywhere. So a verdict
// that rests on values of f, at the ends of a ray and at the extrema of f between them, holds while none of
// these is within e of zero.
#pragma once

#include <array>

#include "truth/scene_data.hpp"

namespace raytorus::truth {

class TubeDistance {
public:
    /// `local`: in the torus' frame.
    TubeDistance(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& local);

    /// t in lengths of the ray's direction.
    [[nodiscard]] double at(double t) const;

    /// Where f has its extrema, ascending; of the whole line.
    std::array<double, 3> extrema{};
    int extremumCount = 0;

private:
    // Scaled by powers of two, and counted from a point near the torus.
    reference::BasicTorus<double> shape;
    Vec3<double> point{}, direction{};
    DoubleDouble shift;
    double lengthUnit = 1.0, tUnit = 1.0;
};

/// How far the ray is from meeting the surface between t = 0 and tMax, on whichever side of it; negative if
/// it does meet it, and then how far it would have to be moved to meet it no more. With f's least and largest
/// value there, max(least, -largest): 1-Lipschitz like f.
double clearanceOf(const TubeDistance& distance, double tMax);

/// How far, at least, the ray stays from the sphere round the torus between t = 0 and tMax; negative if it
/// meets the sphere.
double sphereClearance(const scene_io::SceneTorus& torus, const SceneRay<double>& ray, double tMax);

/// The smallest clearanceOf() of all tori, and whose it is.
struct Clearance {
    double length = 0.0;
    int torus = -1;  ///< -1: the scene has none
};
Clearance leastClearance(const SceneData& scene, const SceneRay<DoubleDouble>& ray, double tMax);

}  // namespace raytorus::truth
