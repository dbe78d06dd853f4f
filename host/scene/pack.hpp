// SPDX-License-Identifier: MIT
// A scene's parts as the shaders read them: float32, in world units.
#pragma once

#include <cstddef>

#include "scene/scene.hpp"
#include "scene_io.h"

namespace raytorus::scene {

/// Camera, lights and sizes as the shaders read them.
scene_io::SceneFrame makeFrame(const Scene& scene, int width, int height);

/// One torus as the shaders read it. `index` is its place in the scene.
scene_io::SceneTorus makeTorus(const TorusInstance& torus, std::size_t index);

/// One material as the shaders read it.
scene_io::SceneMaterial makeMaterial(const Material& material);

}  // namespace raytorus::scene
