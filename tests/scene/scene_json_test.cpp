// SPDX-License-Identifier: MIT
// Each key of a scene arrives where it belongs, each missing one gets its default, and writing loses nothing.
#include "scene/scene_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <string>

namespace raytorus::scene {
namespace {

TEST(SceneJson, ReadsEachKey) {
    const Scene scene = parseScene(R"({
        "$schema": "scene.schema.json", "description": "All of it",
        "image": {"width": 1, "height": 16384},
        "camera": {"position": [1, 2, 3], "target": [4, 5, 6.5], "up": [0, 2, 0], "verticalFieldOfView": 179},
        "background": {"top": [0.1, 0.2, 0.3], "bottom": [0.4, 0.5, 6]},
        "ambient": {"sky": [0.7, 0.8, 0.9], "ground": [0, 0.01, 0.02]},
        "lights": [{"type": "directional", "direction": [0, 0, 9], "radiance": [1, 2, 3]},
                   {"type": "point", "position": [-1, -2, -3], "intensity": [4, 5, 6]}],
        "materials": {"z": {"diffuse": [0, 0.5, 1], "specular": [1, 0, 0.25], "roughness": 1,
                            "checker": {"counts": [2, 65536], "diffuse": [0.3, 0.2, 0.1]}},
                      "a": {}},
        "tori": [{"majorRadius": 0, "minorRadius": 2, "translation": [7, 8, 9],
                  "rotation": {"axis": [0, 3, 0], "degrees": 90}, "scale": 0.5, "material": "a"},
                 {"majorRadius": 1, "minorRadius": 1.5, "rotation": {"quaternion": [2, 0, 0, 0]},
                  "material": "z"}],
        "animation": {"turntable": {"secondsPerTurn": 2.5, "axis": [0, 3, 4], "center": [-1, -2, -3]}}
    })",
                                   "test");

    Scene expected;
    expected.description = "All of it";
    expected.imageWidth = 1;
    expected.imageHeight = 16384;
    expected.camera = {{1, 2, 3}, {4, 5, 6.5}, {0, 2, 0}, 179};
    expected.background = {{0.1, 0.2, 0.3}, {0.4, 0.5, 6}};
    expected.ambient = {{0.7, 0.8, 0.9}, {0, 0.01, 0.02}};
    expected.lights = {{Light::Type::Directional, {0, 0, 9}, {1, 2, 3}},
                       {Light::Type::Point, {-1, -2, -3}, {4, 5, 6}}};
    // In the order of the file, not of the alphabet.
    expected.materials = {{"z", {0, 0.5, 1}, {1, 0, 0.25}, 1, Checker{2, 65536, {0.3, 0.2, 0.1}}},
                          {"a", Material().diffuse, Material().specular, Material().roughness, {}}};
    const double half = std::sqrt(0.5);
    expected.tori = {{0, 2, {7, 8, 9}, glm::dquat(half, 0, half, 0), 0.5, 1},
                     {1, 1.5, {0, 0, 0}, glm::dquat(0, 1, 0, 0), 1, 0}};

    expected.turntable = {2.5, {0, 3, 4}, {-1, -2, -3}};

    ASSERT_EQ(scene.tori.size(), 2U);
    EXPECT_LT(glm::length(scene.tori[0].rotation - expected.tori[0].rotation), 1e-15);
    expected.tori[0].rotation = scene.tori[0].rotation;
    EXPECT_EQ(scene, expected);
}

TEST(SceneJson, TurnsCounterClockwiseSeenFromTheTipOfTheAxis) {
    const Scene scene = parseScene(R"({"tori": [{"majorRadius": 1, "minorRadius": 0.1,
        "rotation": {"axis": [1, 0, 0], "degrees": 90}}]})",
                                   "test");
    const glm::dvec3 axis = scene.tori[0].rotation * glm::dvec3(0, 0, 1);
    EXPECT_LT(glm::distance(axis, glm::dvec3(0, -1, 0)), 1e-15);
}

TEST(SceneJson, ChoosesDefaultsForATorusAlone) {
    const Scene scene = parseScene(R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}]})", "test");
    Scene expected;
    expected.lights = defaultLights();
    expected.materials = {Material{.name = "default"}};
    expected.tori = {TorusInstance{}};
    expected.camera = framingCamera(expected.tori, 1.5);
    EXPECT_EQ(scene, expected);
    EXPECT_FALSE(scene.lights.empty());
}

TEST(SceneJson, TurnsAboutZThroughTheOriginByDefault) {
    const Scene scene = parseScene(R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}],
        "animation": {"turntable": {"secondsPerTurn": 0.5}}})",
                                   "test");
    EXPECT_EQ(scene.turntable, (Turntable{0.5, {0, 0, 1}, {0, 0, 0}}));
}

TEST(SceneJson, KeepsAnEmptyListOfLights) {
    EXPECT_TRUE(parseScene(R"({"lights": [], "tori": [{"majorRadius": 1, "minorRadius": 1}]})", "test")
                    .lights.empty());
}

TEST(SceneJson, LetsTheSceneDefineTheDefaultMaterial) {
    const Scene scene = parseScene(R"({"materials": {"other": {}, "default": {"roughness": 0.9}},
        "tori": [{"majorRadius": 1, "minorRadius": 1},
                 {"majorRadius": 1, "minorRadius": 1, "material": "default"}]})",
                                   "test");
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.tori[0].materialIndex, 1U);
    EXPECT_EQ(scene.tori[1].materialIndex, 1U);
    EXPECT_EQ(scene.materials[1].roughness, 0.9);
}

TEST(SceneJson, FramesAllToriByDefault) {
    // Wide and tall pictures: the narrower side decides.
    for (const double aspectRatio : {0.25, 1.0, 4.0}) {
        const std::vector<TorusInstance> tori = {{1, 0.25, {5, 0, 0}}, {2, 0.5, {-3, 4, 1}, {}, 2}};
        const Camera camera = framingCamera(tori, aspectRatio);
        const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
        const glm::dvec3 up = glm::cross(right, forward);
        const double tangent = std::tan(glm::radians(camera.verticalFieldOfView) / 2);
        double fullest = 0.0;
        for (const TorusInstance& torus : tori) {
            const double radius = torus.scale * (torus.majorRadius + torus.minorRadius);
            const glm::dvec3 centre = torus.translation - camera.position;
            for (int i = 0; i < 360; ++i) {
                const double angle = glm::radians(static_cast<double>(i));
                const glm::dvec3 rim = centre + radius * (std::cos(angle) * right + std::sin(angle) * up);
                const double x = glm::dot(rim, right) / glm::dot(rim, forward) / (tangent * aspectRatio);
                const double y = glm::dot(rim, up) / glm::dot(rim, forward) / tangent;
                fullest = std::max({fullest, std::abs(x), std::abs(y)});
            }
        }
        EXPECT_LE(fullest, 1.0) << aspectRatio;
        EXPECT_GE(fullest, 0.5) << aspectRatio;
    }
}

/// Every member takes part, with numbers that need all their digits.
Scene randomScene(unsigned seed) {
    std::mt19937_64 engine(seed);
    const auto random = [&](double from, double to) {
        return from + (to - from) * std::generate_canonical<double, 53>(engine);
    };
    const auto vector = [&](double from, double to) {
        return glm::dvec3(random(from, to), random(from, to), random(from, to));
    };
    const auto count = [&](int from, int to) {
        return from + static_cast<int>(random(0.0, to - from + 1.0));
    };

    Scene scene;
    scene.description = "\"quoted\", \\ / \t and \xc3\xa9";
    scene.imageWidth = count(1, maxImageSize);
    scene.imageHeight = count(1, maxImageSize);
    scene.camera = {vector(5, 9), vector(-3, 3), {0, 0, random(0.1, 9)}, random(1, 179)};
    scene.background = {vector(0, 2), vector(0, 2)};
    scene.ambient = {vector(0, 2), vector(0, 2)};
    for (int i = count(0, 16); i > 0; --i) {
        scene.lights.push_back({random(0, 1) < 0.5 ? Light::Type::Directional : Light::Type::Point,
                                vector(0.1, 2), vector(0, 3)});
    }
    for (int i = count(1, 5); i > 0; --i) {
        Material material{"m~/ " + std::to_string(i), vector(0, 1), vector(0, 1), random(0.01, 1), {}};
        if (random(0, 1) < 0.5) {
            material.checker = Checker{count(1, 99), count(1, 99), vector(0, 1)};
        }
        scene.materials.push_back(material);
    }
    for (int i = count(1, 9); i > 0; --i) {
        const double exponent = random(-30, 30);
        scene.tori.push_back(
            {random(0, 3), random(0.01, 3), vector(-9, 9),
             glm::angleAxis(random(-9, 9), glm::normalize(vector(-1, 1))), std::exp(exponent),
             static_cast<std::size_t>(count(0, static_cast<int>(scene.materials.size()) - 1))});
    }
    if (random(0, 1) < 0.5) {
        scene.turntable = Turntable{random(0.01, 99), vector(-1, 1), vector(-9, 9)};
    }
    return scene;
}

TEST(SceneJson, ReadsWhatItWrote) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Scene scene = randomScene(seed);
        const std::string text = writeScene(scene);
        ASSERT_EQ(parseScene(text, "written"), scene) << "seed " << seed << "\n" << text;
    }
}

}  // namespace
}  // namespace raytorus::scene
