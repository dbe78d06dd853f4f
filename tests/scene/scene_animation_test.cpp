// SPDX-License-Identifier: MIT
// A scene's moments: the tori turn as one body, about the axis and no other, and come back to the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "scene/scene.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::scene {
namespace {

Scene threeTori() {
    Scene scene;
    scene.description = "three";
    scene.lights = defaultLights();
    scene.materials = {Material{.name = "a"}, Material{.name = "b"}};
    scene.tori = {{1, 0.25, {1, 2, 3}, glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, -1))), 1.5, 1},
                  {2, 0.5, {-4, 0.1, 0.3}, glm::angleAxis(2.9, glm::normalize(glm::dvec3(0, 1, 1))), 1, 0},
                  {0, 1, {0.1, 0.2, 0.3}, {1, 0, 0, 0}, 0.1, 0}};
    scene.turntable = Turntable{3.7, {1, -2, 0.5}, {0.3, 0.7, -1.1}};
    return scene;
}

// Positions are some units long, and turning them rounds a few times: 16 ulp of 1.
constexpr double rounding = 4e-15;

TEST(SceneAnimation, WithoutOneNothingMoves) {
    Scene scene = threeTori();
    scene.turntable.reset();
    EXPECT_EQ(sceneAt(scene, 1.3), scene);
}

TEST(SceneAnimation, OnlyToriMove) {
    const Scene scene = threeTori();
    Scene moved = sceneAt(scene, 1.3);
    EXPECT_NE(moved.tori, scene.tori);
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        EXPECT_NE(moved.tori[i].translation, scene.tori[i].translation);
        EXPECT_NE(moved.tori[i].rotation, scene.tori[i].rotation);
        moved.tori[i].translation = scene.tori[i].translation;
        moved.tori[i].rotation = scene.tori[i].rotation;
    }
    EXPECT_EQ(moved, scene);
}

TEST(SceneAnimation, WholeTurnsComeBackToTheLastBit) {
    Scene scene = threeTori();
    int differ = 0;
    for (const double secondsPerTurn : {3.7, 0.1, 1.0, 1.0 / 3.0, 12.0, 1e-3, 7e5, 24.0 / 25.0}) {
        scene.turntable->secondsPerTurn = secondsPerTurn;
        EXPECT_EQ(sceneAt(scene, 0.0), scene);
        EXPECT_EQ(sceneAt(scene, -0.0), scene);
        for (int turns = -2000; turns <= 2000; ++turns) {
            EXPECT_EQ(sceneAt(scene, turns * secondsPerTurn), scene)
                << turns << " turns of " << secondsPerTurn;
            differ += sceneAt(scene, (turns + 1e-9) * secondsPerTurn) != scene ? 1 : 0;
        }
    }
    EXPECT_EQ(differ, 8 * 4001) << "a billionth of a turn is not a whole one";
}

// As frames ask for it: a turn of 0.1 s in 3 frames at 30 a second, a turn of 1.1 s in 33.
TEST(SceneAnimation, FramesOfAWholeTurnComeBackToTheLastBit) {
    Scene scene = threeTori();
    for (const int framesPerTurn : {3, 33, 24, 7}) {
        for (const double framesPerSecond : {30.0, 24.0, 29.97, 0.1}) {
            scene.turntable->secondsPerTurn = framesPerTurn / framesPerSecond;
            for (int turn = 0; turn < 100; ++turn) {
                EXPECT_EQ(sceneAt(scene, turn * framesPerTurn / framesPerSecond), scene);
            }
        }
    }
}

TEST(SceneAnimation, TurnsCounterClockwiseSeenFromTheTipOfTheAxis) {
    Scene scene = threeTori();
    scene.turntable = Turntable{8, {0, 0, 5}, {1, 0, 0}};
    scene.tori = {{1, 0.25, {3, 0, 4}, {1, 0, 0, 0}, 1, 0}};
    const auto centreAt = [&](double seconds) { return sceneAt(scene, seconds).tori[0].translation; };
    EXPECT_LT(glm::distance(centreAt(2), glm::dvec3(1, 2, 4)), rounding);
    EXPECT_LT(glm::distance(centreAt(4), glm::dvec3(-1, 0, 4)), rounding);
    EXPECT_LT(glm::distance(centreAt(-2), glm::dvec3(1, -2, 4)), rounding);
    EXPECT_LT(glm::distance(centreAt(1), glm::dvec3(1 + std::sqrt(2.0), std::sqrt(2.0), 4)), rounding);
    EXPECT_LT(glm::distance(centreAt(801), centreAt(1)), rounding);

    // The torus turns with its place: what pointed along x points along y after a quarter.
    const glm::dvec3 x = sceneAt(scene, 2).tori[0].rotation * glm::dvec3(1, 0, 0);
    EXPECT_LT(glm::distance(x, glm::dvec3(0, 1, 0)), rounding);
}

/// A point of the torus' own frame, in the scene.
glm::dvec3 inScene(const TorusInstance& torus, const glm::dvec3& point) {
    return torus.translation + torus.rotation * (torus.scale * point);
}

TEST(SceneAnimation, TurnsAsOneBody) {
    const Scene scene = threeTori();
    const glm::dvec3 axis = glm::normalize(scene.turntable->axis);
    const glm::dvec3 center = scene.turntable->center;
    const std::vector<glm::dvec3> marks = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const double seconds : {0.01, 0.5, 1.85, 3.0, 100.0, -1.2}) {
        const Scene moved = sceneAt(scene, seconds);
        const double angle = 2 * std::numbers::pi * seconds / scene.turntable->secondsPerTurn;
        for (std::size_t i = 0; i < scene.tori.size(); ++i) {
            EXPECT_NEAR(glm::length(moved.tori[i].rotation), 1.0, rounding);
            for (const glm::dvec3& mark : marks) {
                // Rodrigues' formula, which has no quaternion in it.
                const glm::dvec3 before = inScene(scene.tori[i], mark) - center;
                const glm::dvec3 after = std::cos(angle) * before +
                                         std::sin(angle) * glm::cross(axis, before) +
                                         (1 - std::cos(angle)) * glm::dot(axis, before) * axis;
                // The angle of 27 turns has lost five bits.
                EXPECT_LT(glm::distance(inScene(moved.tori[i], mark) - center, after),
                          rounding * (1 + std::abs(angle)));
            }
        }
    }
}

TEST(SceneAnimation, EveryMomentIsAValidScene) {
    const Scene scene = threeTori();
    for (const double seconds : {0.3, 1e9, -1e300, 1e-300}) {
        const Scene moved = sceneAt(scene, seconds);
        EXPECT_EQ(parseScene(writeScene(moved), "moved"), moved) << seconds;
    }
}

}  // namespace
}  // namespace raytorus::scene
