// SPDX-License-Identifier: MIT
// From the JSON tree to the scene: what keys there are, what they may hold and what they default to.
#include "scene/scene_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/suggestion.hpp"
#include "core/torus_range.hpp"
#include "scene/bvh.hpp"
#include "scene/json_node.hpp"

namespace raytorus::scene {
namespace {

/// What a torus has that names no material, unless the scene defines a material of this name.
constexpr std::string_view defaultMaterialName = "default";

/// The materials so far, and where each is. The default one appears when it is first asked for.
struct MaterialTable {
    std::vector<Material> materials;
    std::unordered_map<std::string, std::size_t> indices;

    void add(Material material) {
        indices.emplace(material.name, materials.size());
        materials.push_back(std::move(material));
    }
};

constexpr double floatMin = std::numeric_limits<float>::min();
constexpr double floatMax = std::numeric_limits<float>::max();

double largest(const glm::dvec3& vector) {
    return std::max({vector.x, vector.y, vector.z});
}

/// result = what `read` makes of the member, if there is one.
template <class T, class Read>
void readOptional(const JsonNode& node, std::string_view key, T& result, Read read) {
    if (const std::optional<JsonNode> member = node.member(key)) {
        result = read(*member);
    }
}

Camera readCamera(const JsonNode& node) {
    node.expectKeys({"position", "target", "up", "verticalFieldOfView"});
    Camera camera;
    camera.position = node.requiredMember("position").vector();
    camera.target = node.requiredMember("target").vector();
    readOptional(node, "up", camera.up, [](const JsonNode& up) { return up.direction(); });
    readOptional(node, "verticalFieldOfView", camera.verticalFieldOfView, [](const JsonNode& angle) {
        const double degrees = angle.value().is_number() ? angle.number() : 0.0;
        if (!(degrees > 0.0 && degrees < 180.0)) {
            angle.failExpecting("an angle in degrees between 0 and 180");
        }
        return degrees;
    });
    const glm::dvec3 view = camera.target - camera.position;
    if (!(glm::length(view) >= floatMin)) {
        node.requiredMember("target").fail("the target is the camera's position, and so gives no direction");
    }
    // In float32, a smaller angle between the two leaves no digits to tell left from right.
    constexpr double smallestSine = 1e-6;
    if (!(glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.up))) >= smallestSine)) {
        // `up` may be the default.
        node.member("up").value_or(node).fail("the camera's up direction is parallel to its view");
    }
    return camera;
}

Background readBackground(const JsonNode& node) {
    node.expectKeys({"top", "bottom"});
    Background background;
    readOptional(node, "top", background.top, [](const JsonNode& color) { return color.light(); });
    readOptional(node, "bottom", background.bottom, [](const JsonNode& color) { return color.light(); });
    return background;
}

Ambient readAmbient(const JsonNode& node) {
    node.expectKeys({"sky", "ground"});
    Ambient ambient;
    readOptional(node, "sky", ambient.sky, [](const JsonNode& color) { return color.light(); });
    readOptional(node, "ground", ambient.ground, [](const JsonNode& color) { return color.light(); });
    return ambient;
}

Light readLight(const JsonNode& node) {
    node.expectObject();
    const JsonNode type = node.requiredMember("type");
    if (type.value() == "directional") {
        node.expectKeys({"type", "direction", "radiance"});
        return {Light::Type::Directional, node.requiredMember("direction").direction(),
                node.requiredMember("radiance").light()};
    }
    if (type.value() == "point") {
        node.expectKeys({"type", "position", "intensity"});
        return {Light::Type::Point, node.requiredMember("position").vector(),
                node.requiredMember("intensity").light()};
    }
    type.failExpecting("\"directional\" or \"point\"");
}

std::vector<Light> readLights(const JsonNode& node) {
    node.expectArray();
    if (node.value().size() > maxLights) {
        node.failExpecting(fmt::format("an array of at most {} lights", maxLights));
    }
    std::vector<Light> lights;
    for (std::size_t i = 0; i < node.value().size(); ++i) {
        lights.push_back(readLight(node.child(i)));
    }
    return lights;
}

Checker readChecker(const JsonNode& node) {
    node.expectKeys({"counts", "diffuse"});
    Checker checker;
    readOptional(node, "diffuse", checker.diffuse, [](const JsonNode& color) { return color.reflectance(); });
    if (const std::optional<JsonNode> counts = node.member("counts")) {
        if (!counts->value().is_array() || counts->value().size() != 2) {
            counts->failExpecting("an array of two integers");
        }
        checker.countU = counts->child(0).integer(1, maxCheckerCount);
        checker.countV = counts->child(1).integer(1, maxCheckerCount);
    }
    return checker;
}

Material readMaterial(const JsonNode& node) {
    node.expectKeys({"diffuse", "specular", "roughness", "checker"});
    Material material;
    material.name = node.key();
    readOptional(node, "diffuse", material.diffuse,
                 [](const JsonNode& color) { return color.reflectance(); });
    readOptional(node, "specular", material.specular,
                 [](const JsonNode& color) { return color.reflectance(); });
    readOptional(node, "roughness", material.roughness, [](const JsonNode& roughness) {
        // Its fourth power is still a normal float32.
        constexpr double least = 1e-6;
        const double value = roughness.value().is_number() ? roughness.number() : 0.0;
        if (!(value >= least && value <= 1.0)) {
            roughness.failExpecting("a number from 1e-6 to 1");
        }
        return value;
    });
    readOptional(node, "checker", material.checker, readChecker);
    return material;
}

MaterialTable readMaterials(const JsonNode& node) {
    node.expectObject();
    MaterialTable table;
    for (std::size_t i = 0; i < node.value().size(); ++i) {
        table.add(readMaterial(node.child(i)));
    }
    return table;
}

std::size_t defaultMaterial(MaterialTable& table) {
    const std::string name(defaultMaterialName);
    if (!table.indices.contains(name)) {
        Material material;
        material.name = name;
        table.add(material);
    }
    return table.indices.at(name);
}

std::size_t readMaterialName(const JsonNode& node, MaterialTable& table) {
    const std::string name = node.text();
    if (name == defaultMaterialName) {
        return defaultMaterial(table);
    }
    const auto found = table.indices.find(name);
    if (found == table.indices.end()) {
        std::vector<std::string> known;
        for (const Material& material : table.materials) {
            known.push_back(material.name);
        }
        node.fail(fmt::format("{} is not the name of a material{}", describe(node.value()),
                              suggestion(name, known)));
    }
    return found->second;
}

glm::dquat readRotation(const JsonNode& node) {
    node.expectObject();
    if (const std::optional<JsonNode> quaternion = node.member("quaternion")) {
        node.expectKeys({"quaternion"});
        const Json& value = quaternion->value();
        glm::dquat result(0.0, 0.0, 0.0, 0.0);
        if (!value.is_array() || value.size() != 4) {
            quaternion->failExpecting("an array of four numbers");
        }
        result.x = quaternion->child(0).number();
        result.y = quaternion->child(1).number();
        result.z = quaternion->child(2).number();
        result.w = quaternion->child(3).number();
        const double length = glm::length(result);
        if (!(length >= floatMin)) {
            quaternion->fail("the quaternion is zero, and so is no rotation");
        }
        // What is a unit quaternion but for rounding stays as it is: to read what was written changes
        // nothing.
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        return std::abs(length - 1.0) <= rounding ? result : result / length;
    }
    node.expectKeys({"axis", "degrees", "quaternion"});
    const glm::dvec3 axis = glm::normalize(node.requiredMember("axis").direction());
    return glm::angleAxis(glm::radians(node.requiredMember("degrees").number()), axis);
}

/// A radius as the shader gets it must be neither infinite nor so small that a GPU may take it for zero.
void expectFloat(const JsonNode& node, double scaled) {
    if (!(scaled >= floatMin && scaled <= floatMax)) {
        node.fail(fmt::format("times the scale it is {}, outside the normal range of float32", scaled));
    }
}

TorusInstance readTorus(const JsonNode& node, MaterialTable& materials) {
    node.expectKeys({"majorRadius", "minorRadius", "translation", "rotation", "scale", "material"});
    const JsonNode majorRadius = node.requiredMember("majorRadius");
    const JsonNode minorRadius = node.requiredMember("minorRadius");
    TorusInstance torus;
    torus.majorRadius = majorRadius.nonNegativeNumber();
    torus.minorRadius = minorRadius.positiveNumber();
    readOptional(node, "translation", torus.translation,
                 [](const JsonNode& vector) { return vector.vector(); });
    readOptional(node, "rotation", torus.rotation, readRotation);
    readOptional(node, "scale", torus.scale, [](const JsonNode& scale) { return scale.positiveNumber(); });
    const std::optional<JsonNode> material = node.member("material");
    torus.materialIndex = material ? readMaterialName(*material, materials) : defaultMaterial(materials);

    if (torus.majorRadius > 0.0) {
        expectFloat(majorRadius, torus.scale * torus.majorRadius);
    }
    expectFloat(minorRadius, torus.scale * torus.minorRadius);
    if (!isTorusInRange(torus.scale * torus.majorRadius, torus.scale * torus.minorRadius)) {
        node.fail(fmt::format("the radii together, times the scale, are {:g}; they may be {:g} to {:g}",
                              torus.scale * (torus.majorRadius + torus.minorRadius), smallestTorus,
                              largestTorus));
    }
    return torus;
}

void readTori(const JsonNode& node, MaterialTable materials, Scene& scene) {
    node.expectArray();
    if (node.value().empty()) {
        node.fail("the array is empty, but a scene has at least one torus");
    }
    scene.tori.reserve(node.value().size());
    for (std::size_t i = 0; i < node.value().size(); ++i) {
        scene.tori.push_back(readTorus(node.child(i), materials));
    }
    scene.materials = std::move(materials.materials);
}

Turntable readTurntable(const JsonNode& node, const std::vector<TorusInstance>& tori) {
    node.expectKeys({"secondsPerTurn", "axis", "center"});
    Turntable turntable;
    turntable.secondsPerTurn = node.requiredMember("secondsPerTurn").positiveNumber();
    readOptional(node, "axis", turntable.axis, [](const JsonNode& axis) { return axis.direction(); });
    readOptional(node, "center", turntable.center, [](const JsonNode& center) { return center.vector(); });
    const double fromOrigin = glm::length(turntable.center);
    for (const TorusInstance& torus : tori) {
        const double reach = torus.scale * (torus.majorRadius + torus.minorRadius);
        if (!(fromOrigin + glm::distance(turntable.center, torus.translation) + reach <= floatMax)) {
            node.fail("the tori turn beyond the range of float32 (3.4e38)");
        }
    }
    return turntable;
}

Scene readRoot(const JsonNode& root) {
    root.expectKeys({"$schema", "description", "image", "camera", "background", "ambient", "lights",
                     "materials", "tori", "animation"});
    Scene scene;
    std::string schema;  // for editors: read, so that it is a text, and forgotten
    readOptional(root, "$schema", schema, [](const JsonNode& text) { return text.text(); });
    readOptional(root, "description", scene.description, [](const JsonNode& text) { return text.text(); });
    if (const std::optional<JsonNode> image = root.member("image")) {
        image->expectKeys({"width", "height"});
        const auto readSize = [](const JsonNode& size) { return size.integer(1, maxImageSize); };
        readOptional(*image, "width", scene.imageWidth, readSize);
        readOptional(*image, "height", scene.imageHeight, readSize);
    }
    readOptional(root, "background", scene.background, readBackground);
    readOptional(root, "ambient", scene.ambient, readAmbient);
    scene.lights = defaultLights();
    readOptional(root, "lights", scene.lights, readLights);
    MaterialTable materials;
    readOptional(root, "materials", materials, readMaterials);
    readTori(root.requiredMember("tori"), std::move(materials), scene);

    if (const std::optional<JsonNode> animation = root.member("animation")) {
        animation->expectKeys({"turntable"});
        scene.turntable = readTurntable(animation->requiredMember("turntable"), scene.tori);
    }
    if (const std::optional<JsonNode> camera = root.member("camera")) {
        scene.camera = readCamera(*camera);
    } else {
        scene.camera = framingCamera(scene.tori, static_cast<double>(scene.imageWidth) / scene.imageHeight);
        if (!(largest(glm::abs(scene.camera.position)) <= floatMax)) {
            root.requiredMember("tori").fail("the tori reach too far for the default camera; give a camera");
        }
    }
    return scene;
}

}  // namespace

Scene parseScene(std::string_view text, std::string_view sourceName) {
    const Json tree = parseStrictJson(text, sourceName);
    return readRoot(JsonNode(tree, sourceName));
}

Scene readScene(const std::filesystem::path& path) {
    return parseScene(readTextFile(path), path.string());
}

}  // namespace raytorus::scene
