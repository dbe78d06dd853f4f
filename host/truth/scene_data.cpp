// SPDX-License-Identifier: MIT
#include "truth/scene_data.hpp"

#include "scene/pack.hpp"

namespace raytorus::truth {

SceneData makeSceneData(const scene::Scene& scene, int width, int height) {
    SceneData data;
    data.frame = scene::makeFrame(scene, width, height);
    data.lights = static_cast<int>(scene.lights.size());
    data.tori.reserve(scene.tori.size());
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        data.tori.push_back(scene::makeTorus(scene.tori[i], i));
    }
    data.materials.reserve(scene.materials.size());
    for (const scene::Material& material : scene.materials) {
        data.materials.push_back(scene::makeMaterial(material));
    }
    return data;
}

}  // namespace raytorus::truth
