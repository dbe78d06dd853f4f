// SPDX-License-Identifier: MIT
// Defaults of a scene that depend on what is in it.
#include "render/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/bvh.hpp"

namespace raytorus::render {

Camera framingCamera(const std::vector<TorusInstance>& tori, double aspectRatio) {
    Camera camera;
    if (tori.empty()) {
        return camera;
    }
    Box all = boundsOf(tori.front());
    for (const TorusInstance& torus : tori) {
        const Box box = boundsOf(torus);
        all.minimum = glm::min(all.minimum, box.minimum);
        all.maximum = glm::max(all.maximum, box.maximum);
    }
    const glm::dvec3 centre = 0.5 * (all.minimum + all.maximum);
    double radius = 0.0;
    for (const TorusInstance& torus : tori) {
        const double reach = torus.scale * (torus.majorRadius + torus.minorRadius);
        radius = std::max(radius, glm::distance(centre, torus.translation) + reach);
    }
    // The sphere touches the edges of the narrower side; the air round it is what a sphere has to spare round
    // tori.
    const double tangent =
        std::tan(0.5 * glm::radians(camera.verticalFieldOfView)) * std::min(1.0, aspectRatio);
    const double distance = radius / std::sin(std::atan(tangent));
    const glm::dvec3 towardsCamera = glm::normalize(glm::dvec3(0.4, -0.8, 0.55));
    camera.target = centre;
    camera.position = centre + distance * towardsCamera;
    return camera;
}

std::vector<Light> defaultLights() {
    const Light key{Light::Type::Directional, {-0.5, -0.55, 0.9}, {0.9, 0.86, 0.79}};
    const Light fill{Light::Type::Directional, {0.9, -0.35, 0.2}, {0.16, 0.2, 0.27}};
    return {key, fill};
}

}  // namespace raytorus::render
