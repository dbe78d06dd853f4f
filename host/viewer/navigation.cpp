// SPDX-License-Identifier: MIT
#include "viewer/navigation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/rotate_vector.hpp>
#include <glm/trigonometric.hpp>

namespace raytorus::viewer {
namespace {

constexpr double poleGap = 0.01;  // radians between the line of sight and `up`: there, `right` is still sure

struct Axes {
    glm::dvec3 forward, right, up;
    double distance;
};

Axes axesOf(const scene::Camera& camera) {
    const glm::dvec3 sight = camera.target - camera.position;
    const double distance = glm::length(sight);
    const glm::dvec3 forward = sight / distance;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {forward, right, glm::cross(right, forward), distance};
}

}  // namespace

scene::Camera orbit(const scene::Camera& camera, double across, double upwards) {
    const Axes axes = axesOf(camera);
    const glm::dvec3 pole = glm::normalize(camera.up);
    const double fromPole = std::acos(std::clamp(glm::dot(-axes.forward, pole), -1.0, 1.0));
    // Nearer to a pole than the gap may be where the scene put the camera: then only the way out is open.
    const double least = std::min(fromPole, poleGap);
    const double most = std::max(fromPole, glm::pi<double>() - poleGap);
    const double turn = fromPole - std::clamp(fromPole - upwards, least, most);
    glm::dvec3 back = camera.position - camera.target;
    back = glm::rotate(back, -turn, axes.right);
    back = glm::rotate(back, across, pole);
    scene::Camera moved = camera;
    moved.position = camera.target + back;
    return moved;
}

scene::Camera pan(const scene::Camera& camera, double x, double y) {
    const Axes axes = axesOf(camera);
    const double height = 2.0 * axes.distance * std::tan(0.5 * glm::radians(camera.verticalFieldOfView));
    const glm::dvec3 step = -height * (x * axes.right + y * axes.up);
    scene::Camera moved = camera;
    moved.position += step;
    moved.target += step;
    return moved;
}

scene::Camera dolly(const scene::Camera& camera, double factor) {
    const glm::dvec3 back = camera.position - camera.target;
    const double distance = glm::length(back);
    // Between what float32 can tell apart near the target and what it can hold far away.
    const double size = std::max(1e-6, glm::length(camera.target) * 1e-6);
    const double wanted = std::clamp(distance / factor, std::min(distance, size), std::max(distance, 1e9));
    scene::Camera moved = camera;
    moved.position = camera.target + back * (wanted / distance);
    return moved;
}

scene::Camera fit(const scene::Camera& camera, std::span<const scene::TorusInstance> tori,
                  double aspectRatio) {
    const scene::Sphere all = scene::enclosingSphere(tori);
    const glm::dvec3 back = glm::normalize(camera.position - camera.target);
    scene::Camera moved = camera;
    moved.target = all.center;
    moved.position = all.center + back * scene::framingDistance(camera, all.radius, aspectRatio);
    return moved;
}

scene::Camera preset(Preset which, const scene::Camera& camera, std::span<const scene::TorusInstance> tori,
                     double aspectRatio) {
    scene::Camera from = camera;
    from.up = {0.0, 0.0, 1.0};
    from.target = glm::dvec3(0.0);
    switch (which) {
        case Preset::Front:
            from.position = {0.0, -1.0, 0.0};
            break;
        case Preset::Back:
            from.position = {0.0, 1.0, 0.0};
            break;
        case Preset::Left:
            from.position = {-1.0, 0.0, 0.0};
            break;
        case Preset::Right:
            from.position = {1.0, 0.0, 0.0};
            break;
        case Preset::Top:
            from.position = {0.0, 0.0, 1.0};
            break;
        case Preset::Bottom:
            from.position = {0.0, 0.0, -1.0};
            break;
        case Preset::Corner:
            from.position = {1.0, -1.6, 1.1};
            break;
    }
    if (which == Preset::Top || which == Preset::Bottom) {
        from.up = {0.0, 1.0, 0.0};
    }
    return fit(from, tori, aspectRatio);
}

}  // namespace raytorus::viewer
