// SPDX-License-Identifier: MIT
// A scene that moves, at one moment.
#pragma once

#include "scene/scene.hpp"

namespace raytorus::scene {

/// The scene with its tori where they are at this time, which is finite; negative is before the start. At 0,
/// and whenever whole turns have passed, as nearly as a double tells time, they are exactly where the scene
/// has them. A scene in which nothing moves stays as it is.
[[nodiscard]] Scene sceneAt(const Scene& scene, double seconds);

}  // namespace raytorus::scene
