// SPDX-License-Identifier: MIT
#include "render/scene_buffers.hpp"

#include <utility>
#include <vector>

#include "scene/bvh.hpp"
#include "scene/pack.hpp"

namespace raytorus::render {

SceneStorage storageFor(const scene::Scene& scene) {
    const bool fits =
        scene.tori.size() <= SCENE_SMALL_TORI && scene.materials.size() <= SCENE_SMALL_MATERIALS;
    return fits ? SceneStorage::Uniform : SceneStorage::Buffer;
}

std::vector<gpu::Binding> sceneBindings() {
    constexpr VkDescriptorType uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    return {{SCENE_BINDING_FRAME, uniform},          {SCENE_BINDING_TORI, uniform},
            {SCENE_BINDING_NODES, uniform},          {SCENE_BINDING_MATERIALS, uniform},
            {SCENE_BINDING_TORI_LARGE, storage},     {SCENE_BINDING_NODES_LARGE, storage},
            {SCENE_BINDING_MATERIALS_LARGE, storage}};
}

template <typename T>
SceneBuffers::Array SceneBuffers::upload(const gpu::Context& context, std::vector<T> items,
                                         SceneStorage storage, std::size_t uniformLength) {
    const bool large = storage == SceneStorage::Buffer;
    Array array;
    array.storage = gpu::makeBuffer(context, large ? std::span<const T>(items) : std::span<const T>(),
                                    gpu::BufferUse::Storage);
    // A uniform block has the length that its shader declares.
    items.resize(uniformLength);
    array.uniform = gpu::makeBuffer(context, std::span<const T>(items), gpu::BufferUse::Uniform);
    return array;
}

SceneBuffers::SceneBuffers(const gpu::Context& context, const scene::Scene& scene, int width, int height) {
    frame = gpu::Buffer(context, sizeof(scene_io::SceneFrame), gpu::BufferUse::Uniform);
    setFrame(scene, width, height);
    const SceneStorage storage = storageFor(scene);

    std::vector<scene::Box> boxes;
    boxes.reserve(scene.tori.size());
    for (const scene::TorusInstance& torus : scene.tori) {
        boxes.push_back(scene::boundsOf(torus));
    }
    scene::Bvh bvh = scene::buildBvh(boxes);
    static_assert(sizeof(scene::BvhNode) == sizeof(scene_io::SceneNode));
    nodes = upload(context, std::move(bvh.nodes), storage, SCENE_SMALL_NODES);

    std::vector<scene_io::SceneTorus> sorted;
    sorted.reserve(scene.tori.size());
    for (const std::uint32_t index : bvh.order) {
        sorted.push_back(scene::makeTorus(scene.tori[index], index));
    }
    tori = upload(context, std::move(sorted), storage, SCENE_SMALL_TORI);

    std::vector<scene_io::SceneMaterial> packed;
    packed.reserve(scene.materials.size());
    for (const scene::Material& material : scene.materials) {
        packed.push_back(scene::makeMaterial(material));
    }
    materials = upload(context, std::move(packed), storage, SCENE_SMALL_MATERIALS);
}

void SceneBuffers::setFrame(const scene::Scene& scene, int width, int height) {
    frame.as<scene_io::SceneFrame>().front() = scene::makeFrame(scene, width, height);
}

void SceneBuffers::bindTo(gpu::Pipeline& pipeline) const {
    pipeline.bind(SCENE_BINDING_FRAME, frame);
    pipeline.bind(SCENE_BINDING_TORI, tori.uniform);
    pipeline.bind(SCENE_BINDING_NODES, nodes.uniform);
    pipeline.bind(SCENE_BINDING_MATERIALS, materials.uniform);
    pipeline.bind(SCENE_BINDING_TORI_LARGE, tori.storage);
    pipeline.bind(SCENE_BINDING_NODES_LARGE, nodes.storage);
    pipeline.bind(SCENE_BINDING_MATERIALS_LARGE, materials.storage);
}

}  // namespace raytorus::render
