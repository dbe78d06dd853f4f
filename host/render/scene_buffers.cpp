// SPDX-License-Identifier: MIT
#include "render/scene_buffers.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>
#include <vector>

#include "render/bvh.hpp"

namespace raytorus::render {
namespace {

scene_io::vec4 pack(const glm::dvec3& v, double w = 0.0) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

scene_io::SceneLight pack(const Light& light) {
    const bool directional = light.type == Light::Type::Directional;
    return {directional ? pack(glm::normalize(light.vector)) : pack(light.vector, 1.0), pack(light.color)};
}

}  // namespace

scene_io::SceneFrame makeFrame(const Scene& scene, int width, int height) {
    const Camera& camera = scene.camera;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double halfHeight = std::tan(0.5 * glm::radians(camera.verticalFieldOfView));
    const double halfWidth = halfHeight * width / height;
    scene_io::SceneFrame frame{};
    frame.cameraPosition = pack(camera.position);
    frame.cameraForward = pack(forward);
    frame.cameraRight = pack(halfWidth * right);
    frame.cameraUp = pack(halfHeight * up);
    frame.backgroundTop = pack(scene.background.top);
    frame.backgroundBottom = pack(scene.background.bottom);
    frame.ambientSky = pack(scene.ambient.sky);
    frame.ambientGround = pack(scene.ambient.ground);
    frame.size = {width, height, 0.0F, 0.0F};
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        frame.lights[i] = pack(scene.lights[i]);
    }
    return frame;
}

scene_io::SceneTorus makeTorus(const TorusInstance& torus, std::size_t index) {
    const glm::dmat3 rotation =
        glm::mat3_cast(torus.rotation);  // its columns are the torus' axes in the world
    return {pack(rotation[0], torus.translation.x),
            pack(rotation[1], torus.translation.y),
            pack(rotation[2], torus.translation.z),
            {torus.scale * torus.majorRadius, torus.scale * torus.minorRadius, 0.0, 0.0},
            {static_cast<int>(index), static_cast<int>(torus.materialIndex), 0, 0}};
}

scene_io::SceneMaterial makeMaterial(const Material& material) {
    scene_io::SceneMaterial packed{pack(material.diffuse, material.roughness), pack(material.specular),
                                   scene_io::vec4(0.0F), scene_io::vec4(0.0F)};
    if (material.checker) {
        packed.checkerDiffuse = pack(material.checker->diffuse);
        packed.checkerCounts = {material.checker->countU, material.checker->countV, 0.0F, 0.0F};
    }
    return packed;
}

SceneStorage storageFor(const Scene& scene) {
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

SceneBuffers::SceneBuffers(const gpu::Context& context, const Scene& scene, int width, int height) {
    frame = gpu::Buffer(context, sizeof(scene_io::SceneFrame), gpu::BufferUse::Uniform);
    setFrame(scene, width, height);
    const SceneStorage storage = storageFor(scene);

    std::vector<Box> boxes;
    boxes.reserve(scene.tori.size());
    for (const TorusInstance& torus : scene.tori) {
        boxes.push_back(boundsOf(torus));
    }
    Bvh bvh = buildBvh(boxes);
    static_assert(sizeof(BvhNode) == sizeof(scene_io::SceneNode));
    nodes = upload(context, std::move(bvh.nodes), storage, SCENE_SMALL_NODES);

    std::vector<scene_io::SceneTorus> sorted;
    sorted.reserve(scene.tori.size());
    for (const std::uint32_t index : bvh.order) {
        sorted.push_back(makeTorus(scene.tori[index], index));
    }
    tori = upload(context, std::move(sorted), storage, SCENE_SMALL_TORI);

    std::vector<scene_io::SceneMaterial> packed;
    packed.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        packed.push_back(makeMaterial(material));
    }
    materials = upload(context, std::move(packed), storage, SCENE_SMALL_MATERIALS);
}

void SceneBuffers::setFrame(const Scene& scene, int width, int height) {
    frame.as<scene_io::SceneFrame>().front() = makeFrame(scene, width, height);
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
