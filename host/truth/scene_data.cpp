// SPDX-License-Identifier: MIT
#include "truth/scene_data.hpp"

#include "render/scene_buffers.hpp"

namespace raytorus::truth {

SceneData makeSceneData(const render::Scene& scene, int width, int height) {
    SceneData data;
    data.frame = render::makeFrame(scene, width, height);
    data.lights = static_cast<int>(scene.lights.size());
    data.tori.reserve(scene.tori.size());
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        data.tori.push_back(render::makeTorus(scene.tori[i], i));
    }
    data.materials.reserve(scene.materials.size());
    for (const render::Material& material : scene.materials) {
        data.materials.push_back(render::makeMaterial(material));
    }
    return data;
}

}  // namespace raytorus::truth
