// SPDX-License-Identifier: MIT
#include "scene/scene_animation.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>

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
