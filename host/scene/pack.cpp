// SPDX-License-Identifier: MIT
#include "scene/pack.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace raytorus::scene {
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

}  // namespace raytorus::scene
