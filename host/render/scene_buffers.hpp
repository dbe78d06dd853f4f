// SPDX-License-Identifier: MIT
// A scene as the shaders read it: float32, in world units, tori in the order of the bounding volume
// hierarchy.
#pragma once

#include "gpu/buffer.hpp"
#include "render/scene.hpp"
#include "scene_io.h"

namespace raytorus::render {

struct SceneBuffers {
    SceneBuffers(const gpu::Context& context, const Scene& scene, int width, int height, int samplesPerSide);

    gpu::Buffer frame;
    gpu::Buffer tori;
    gpu::Buffer nodes;
    gpu::Buffer materials;
};

/// Camera, lights and sizes as the shaders read them.
scene_io::SceneFrame makeFrame(const Scene& scene, int width, int height, int samplesPerSide);

/// One torus as the shaders read it. `index` is its place in the scene.
scene_io::SceneTorus makeTorus(const TorusInstance& torus, std::size_t index);

}  // namespace raytorus::render
