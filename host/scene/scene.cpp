// SPDX-License-Identifier: MIT
// Defaults of a scene that depend on what is in it, and a scene in motion.
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "scene/bvh.hpp"

namespace raytorus::scene {

namespace {

/// Since the last whole turn, or before the next one, whichever is nearer; exactly 0 at a whole turn.
double secondsIntoTurn(double seconds, double secondsPerTurn) {
    const double part = std::remainder(seconds, secondsPerTurn);  // exact
    // Both numbers are off by half an ulp from those that were meant, 1/24 s or 0.1 s.
    const bool whole = std::abs(part) <= std::numeric_limits<double>::epsilon() * std::abs(seconds);
    return whole ? 0.0 : part;
}

}  // namespace

Sphere enclosingSphere(std::span<const TorusInstance> tori) {
    Box all = boundsOf(tori.front());
    for (const TorusInstance& torus : tori) {
        const Box box = boundsOf(torus);
        all.minimum = glm::min(all.minimum, box.minimum);
        all.maximum = glm::max(all.maximum, box.maximum);
    }
    Sphere sphere{0.5 * (all.minimum + all.maximum), 0.0};
    for (const TorusInstance& torus : tori) {
        const double reach = torus.scale * (torus.majorRadius + torus.minorRadius);
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, torus.translation) + reach);
    }
    return sphere;
}

double framingDistance(const Camera& camera, double radius, double aspectRatio) {
    const double tangent =
        std::tan(0.5 * glm::radians(camera.verticalFieldOfView)) * std::min(1.0, aspectRatio);
    return radius / std::sin(std::atan(tangent));
}

Camera framingCamera(const std::vector<TorusInstance>& tori, double aspectRatio) {
    Camera camera;
    if (tori.empty()) {
        return camera;
    }
    const Sphere all = enclosingSphere(tori);
    // The air round the sphere is what it has to spare round tori.
    const double distance = framingDistance(camera, all.radius, aspectRatio);
    const glm::dvec3 towardsCamera = glm::normalize(glm::dvec3(0.4, -0.8, 0.55));
    camera.target = all.center;
    camera.position = all.center + distance * towardsCamera;
    return camera;
}

std::vector<Light> defaultLights() {
    const Light key{Light::Type::Directional, {-0.5, -0.55, 0.9}, {0.9, 0.86, 0.79}};
    const Light fill{Light::Type::Directional, {0.9, -0.35, 0.2}, {0.16, 0.2, 0.27}};
    return {key, fill};
}

Scene sceneAt(const Scene& scene, double seconds) {
    Scene moved = scene;
    if (!scene.turntable) {
        return moved;
    }
    const Turntable& table = *scene.turntable;
    const double part = secondsIntoTurn(seconds, table.secondsPerTurn);
    if (part == 0.0) {
        return moved;
    }
    const double angle = 2.0 * std::numbers::pi * (part / table.secondsPerTurn);
    const glm::dquat turn = glm::angleAxis(angle, glm::normalize(table.axis));
    for (TorusInstance& torus : moved.tori) {
        torus.translation = table.center + turn * (torus.translation - table.center);
        torus.rotation = glm::normalize(turn * torus.rotation);
    }
    return moved;
}

}  // namespace raytorus::scene
