// SPDX-License-Identifier: MIT
// A ray and all tori of a scene: which of them it meets first, where, and how many surfaces it crosses.
#pragma once

#include "reference/intersect.hpp"
#include "truth/scene_data.hpp"

namespace raytorus::truth {

/// t counts in lengths of the direction, from 0.
template <class Real>
struct Crossings {
    int torus = -1;  ///< that is hit first, or -1
    Real t{};
    Vec3<Real> position{};  ///< of that hit, in its torus' frame
    int count = 0;          ///< of surfaces
};

/// Whether the line certainly misses the sphere round the torus: an intersection in many bits costs a
/// thousand times as much. Doubles lose some 1e-15 of the origin's distance, the rows of the rotation 1e-7 of
/// the size.
template <class Real>
bool passesBy(const SceneRay<Real>& local, double radius) {
    const Vec3<double> origin = toDoubles(local.origin);
    const Vec3<double> direction = toDoubles(local.direction);
    const double toFoot = -dot(origin, direction) / dot(direction, direction);
    const double nearest = length(origin + toFoot * direction);
    return nearest > radius * (1.0 + 1e-6) + 1e-14 * length(origin);
}

/// localRay: from a torus to the ray in its frame, a SceneRay<Real>. Reduced in Real, solved in Solving.
template <class Real, class Solving = Real, class LocalRay>
Crossings<Solving> crossings(const SceneData& scene, const LocalRay& localRay, double tMax) {
    Crossings<Solving> found;
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const scene_io::SceneTorus& torus = scene.tori[i];
        const SceneRay<Real> local = localRay(torus);
        if (passesBy(local, outerRadius(torus))) {
            continue;
        }
        const reference::BasicRay<Real> whole(local.origin, Real(0.0), local.direction, Real(tMax));
        const auto hits =
            reference::intersectAs<Real, Solving>(reference::BasicTorus<Real>(shapeOf(torus)), whole);
        found.count += hits.count;
        if (hits.count > 0 && (found.torus < 0 || hits.hits[0].t < found.t)) {
            found.torus = static_cast<int>(i);
            found.t = hits.hits[0].t;
            found.position = hits.hits[0].position;
        }
    }
    return found;
}

}  // namespace raytorus::truth
