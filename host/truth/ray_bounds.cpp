// SPDX-License-Identifier: MIT
#include "truth/ray_bounds.hpp"

namespace raytorus::truth {

double libraryEnd(const scene_io::SceneTorus& torus) {
    return reference::clearEndMargin(shapeOf(torus)) * static_cast<double>(torus.radii.y);
}

CameraBounds cameraBounds(const scene_io::SceneFrame& frame, const PicturePoint<Rounded>& point) {
    const Vec3<Rounded> direction = lookAt(frame, point);
    const double exactLength = length(toDoubles(direction));
    // The length belongs to the components as they are, so that their own errors are no error of it.
    const Vec3<Rounded> asItIs = fromDoubles<Rounded>(toDoubles(direction));
    const Rounded rounded = squareRoot(dot(asItIs, asItIs));
    return {errorLength(direction) / exactLength + floatRounding,
            rounded.error / exactLength + floatRounding};
}

Displacement displacementAt(const scene_io::SceneTorus& torus, const SceneRay<Rounded>& ray) {
    const SceneRay<Rounded> local = toTorus(torus, ray);
    return {errorLength(local.origin), errorLength(local.direction)};
}

}  // namespace raytorus::truth
