// SPDX-License-Identifier: MIT
// A scene as the shaders read it: float32, in world units, tori in the order of the bounding volume
// hierarchy.
#pragma once

#include <vector>

#include "gpu/pipeline.hpp"
#include "scene/scene.hpp"
#include "scene_io.h"

namespace raytorus::render {

/// Where the shaders find tori, nodes and materials: in uniform blocks, or, if those are too small, in
/// storage buffers.
enum class SceneStorage { Uniform = SCENE_STORAGE_UNIFORM, Buffer = SCENE_STORAGE_BUFFER };

SceneStorage storageFor(const scene::Scene& scene);

/// The bindings of every picture shader that belong to the scene.
std::vector<gpu::Binding> sceneBindings();

class SceneBuffers {
public:
    SceneBuffers(const gpu::Context& context, const scene::Scene& scene, int width, int height);

    /// Another camera, lights or size; the tori stay.
    void setFrame(const scene::Scene& scene, int width, int height);

    void bindTo(gpu::Pipeline& pipeline) const;

private:
    // One array in both kinds of storage. The one that is not used is there because each binding needs a
    // buffer.
    struct Array {
        gpu::Buffer uniform;
        gpu::Buffer storage;
    };
    template <typename T>
    static Array upload(const gpu::Context& context, std::vector<T> items, SceneStorage storage,
                        std::size_t uniformLength);

    gpu::Buffer frame;
    Array tori;
    Array nodes;
    Array materials;
};

}  // namespace raytorus::render
