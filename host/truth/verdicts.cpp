// SPDX-License-Identifier: MIT
#include "truth/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "truth/sample.hpp"

namespace raytorus::truth {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// The line of sight and one torus.
class Passage {
public:
    Passage(const scene_io::SceneTorus& which, const SceneRay<DoubleDouble>& ray, const CameraBounds& camera)
        : torus(which),
          local(toTorus(which, ray)),
          distance(which, local),
          displacement(cameraDisplacement(which, ray, camera)),
          far(length(toDoubles(local.origin)) + outerRadius(which)),
          hits(quickCrossings(which, local)) {}

    // What the ray may be displaced near t, the library's own error included.
    double allowance(double t) const {
        return displacement.at(std::clamp(t, 0.0, far)) + positionBound * outerRadius(torus);
    }

    // On which side of the surface the camera is.
    double startMargin() const {
        return std::abs(distance.at(0.0)) / std::max(allowance(0.0), libraryEnd(torus));
    }

    // Tangents at t from 0 to tMax.
    double tangentMargin(double tMax) const {
        double margin = endless;
        for (std::size_t i = 0; i < static_cast<std::size_t>(distance.extremumCount); ++i) {
            const double t = distance.extrema[i];
            if (t > 0.0 && t < tMax) {
                margin = std::min(margin, std::abs(distance.at(t)) / allowance(t));
            }
        }
        return margin;
    }

    double cosine(const reference::BasicHit<double>& hit) const {
        const SurfacePoint<double> point = inTorusFrame(torus, hit.position);
        return std::abs(dot(point.outward, toDoubles(local.direction)));
    }

    // A crossing can also become three, or vanish, where f is nearly flat without having an extremum. With
    // curvatures up to k, f keeps falling or rising for cos^2 / (2 k) on either side of the surface.
    double crossingMargin(const reference::BasicHit<double>& hit) const {
        const double r = static_cast<double>(torus.radii.y);
        const double rho = std::hypot(hit.position[0], hit.position[1]);
        const double cosV = std::abs(rho - static_cast<double>(torus.radii.x)) / r;
        const double curvature = std::max(1.0 / r, 2.0 * cosV / rho);
        const double across = cosine(hit);
        return across * across / (2.0 * curvature) / allowance(hit.t);
    }

    double countMargin() const {
        double margin = std::min(startMargin(), tangentMargin(endless));
        for (int i = 0; i < hits.count; ++i) {
            margin = std::min(margin, crossingMargin(hits.hits[static_cast<std::size_t>(i)]));
        }
        return margin;
    }

    const scene_io::SceneTorus& torus;
    SceneRay<DoubleDouble> local;
    TubeDistance distance;
    Displacement displacement;
    double far;  // beyond it there is nothing of the torus
    reference::BasicIntersections<double> hits;
};

}  // namespace

Displacement frameDisplacement(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& ray) {
    return displacementAt(
        torus, {fromDoubles<Rounded>(toDoubles(ray.origin)), fromDoubles<Rounded>(toDoubles(ray.direction))});
}

Displacement cameraDisplacement(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& ray,
                                const CameraBounds& camera) {
    const Displacement frame = frameDisplacement(torus, ray);
    return {frame.origin, frame.perT + camera.turned};
}

VerdictMargins verdictMargins(const SceneData& scene, const SceneRay<DoubleDouble>& ray,
                              const CameraBounds& camera, int torus, double t) {
    const SceneRay<double> plain{toDoubles(ray.origin), toDoubles(ray.direction)};
    VerdictMargins margins{endless, endless};
    // The hit itself may lie nearer or farther by what a displacement does to it, twice for the curvature.
    double hitShift = 0.0;
    if (torus >= 0) {
        const Passage passage(scene.tori[static_cast<std::size_t>(torus)], ray, camera);
        if (passage.hits.count == 0) {  // a tangent so close that doubles do not see it
            return {0.0, 0.0};
        }
        const reference::BasicHit<double>& hit = passage.hits.hits[0];
        margins.nearest =
            std::min({passage.startMargin(), passage.tangentMargin(hit.t), passage.crossingMargin(hit)});
        hitShift = 2.0 * passage.allowance(hit.t) / passage.cosine(hit);
    }
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const double clear = sphereClearance(scene.tori[i], plain, endless);
        if (clear > 0.0) {
            const Displacement shift = cameraDisplacement(scene.tori[i], ray, camera);
            const double reach =
                length(originOf<double>(scene.tori[i]) - plain.origin) + outerRadius(scene.tori[i]);
            const double passes = clear / (shift.at(reach) + positionBound * outerRadius(scene.tori[i]));
            if (passes > std::max(margins.nearest, margins.count)) {
                continue;
            }
        }
        const Passage passage(scene.tori[i], ray, camera);
        margins.count = std::min(margins.count, passage.countMargin());
        if (static_cast<int>(i) != torus) {
            const double before = torus < 0 ? farthest : t;
            const double clearance = std::abs(clearanceOf(passage.distance, before));
            margins.nearest = std::min(margins.nearest, clearance / (passage.allowance(before) + hitShift));
        }
    }
    return margins;
}

}  // namespace raytorus::truth
