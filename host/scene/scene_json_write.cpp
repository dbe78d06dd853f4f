// SPDX-License-Identifier: MIT
// From the scene to JSON: every key (that of an animation only if there is one), in the order of
// docs/scenes.md, numbers with as many digits as they need.
#include <glm/gtc/quaternion.hpp>

#include "core/json_text.hpp"
#include "core/strict_json.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::scene {
namespace {

Json toJson(const glm::dvec3& vector) {
    return Json::array({vector.x, vector.y, vector.z});
}

Json toJson(const Camera& camera) {
    return {{"position", toJson(camera.position)},
            {"target", toJson(camera.target)},
            {"up", toJson(camera.up)},
            {"verticalFieldOfView", camera.verticalFieldOfView}};
}

Json toJson(const Light& light) {
    if (light.type == Light::Type::Directional) {
        return {
            {"type", "directional"}, {"direction", toJson(light.vector)}, {"radiance", toJson(light.color)}};
    }
    return {{"type", "point"}, {"position", toJson(light.vector)}, {"intensity", toJson(light.color)}};
}

Json toJson(const Material& material) {
    Json json = {{"diffuse", toJson(material.diffuse)},
                 {"specular", toJson(material.specular)},
                 {"roughness", material.roughness}};
    if (material.checker) {
        json["checker"] = {{"counts", Json::array({material.checker->countU, material.checker->countV})},
                           {"diffuse", toJson(material.checker->diffuse)}};
    }
    return json;
}

Json toJson(const TorusInstance& torus, const std::vector<Material>& materials) {
    const glm::dquat& q = torus.rotation;
    return {{"majorRadius", torus.majorRadius},
            {"minorRadius", torus.minorRadius},
            {"translation", toJson(torus.translation)},
            // Not axis and angle: the quaternion would not come back to the last bit.
            {"rotation", {{"quaternion", Json::array({q.x, q.y, q.z, q.w})}}},
            {"scale", torus.scale},
            {"material", materials.at(torus.materialIndex).name}};
}

}  // namespace

std::string writeScene(const Scene& scene) {
    Json json;
    json["description"] = scene.description;
    json["image"] = {{"width", scene.imageWidth}, {"height", scene.imageHeight}};
    json["camera"] = toJson(scene.camera);
    json["background"] = {{"top", toJson(scene.background.top)}, {"bottom", toJson(scene.background.bottom)}};
    json["ambient"] = {{"sky", toJson(scene.ambient.sky)}, {"ground", toJson(scene.ambient.ground)}};
    json["lights"] = Json::array();
    for (const Light& light : scene.lights) {
        json["lights"].push_back(toJson(light));
    }
    json["materials"] = Json::object();
    for (const Material& material : scene.materials) {
        json["materials"][material.name] = toJson(material);
    }
    json["tori"] = Json::array();
    for (const TorusInstance& torus : scene.tori) {
        json["tori"].push_back(toJson(torus, scene.materials));
    }
    if (scene.turntable) {
        json["animation"] = {{"turntable",
                              {{"secondsPerTurn", scene.turntable->secondsPerTurn},
                               {"axis", toJson(scene.turntable->axis)},
                               {"center", toJson(scene.turntable->center)}}}};
    }
    return dumpJson(json) + "\n";
}

}  // namespace raytorus::scene
