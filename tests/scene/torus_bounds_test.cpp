// SPDX-License-Identifier: MIT
// The box of a placed torus holds its surface and touches it on all six sides.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "scene/bvh.hpp"

namespace raytorus::scene {
namespace {

glm::dvec3 surfacePoint(const TorusInstance& torus, double u, double v) {
    const double ring = torus.majorRadius + torus.minorRadius * std::cos(v);
    const glm::dvec3 local(ring * std::cos(u), ring * std::sin(u), torus.minorRadius * std::sin(v));
    return torus.translation + torus.rotation * (torus.scale * local);
}

void expectTight(const TorusInstance& torus, const std::string& name) {
    const Box box = boundsOf(torus);
    constexpr int stepsU = 400;
    constexpr int stepsV = 200;
    Box sampled{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (int i = 0; i < stepsU; ++i) {
        for (int j = 0; j < stepsV; ++j) {
            const glm::dvec3 point =
                surfacePoint(torus, 2 * std::numbers::pi * i / stepsU, 2 * std::numbers::pi * j / stepsV);
            sampled = {glm::min(sampled.minimum, point), glm::max(sampled.maximum, point)};
        }
    }
    // Samples miss an extreme by 1 - cos(half a step) of the radius; the box is widened by float32 roundings.
    const double radius = torus.scale * (torus.majorRadius + torus.minorRadius);
    for (int axis = 0; axis < 3; ++axis) {
        const double slack = 3e-4 * radius + 1e-6 * std::abs(torus.translation[axis]);
        EXPECT_LE(box.minimum[axis], sampled.minimum[axis]) << name << ", axis " << axis;
        EXPECT_GE(box.maximum[axis], sampled.maximum[axis]) << name << ", axis " << axis;
        EXPECT_GE(box.minimum[axis], sampled.minimum[axis] - slack) << name << ", axis " << axis;
        EXPECT_LE(box.maximum[axis], sampled.maximum[axis] + slack) << name << ", axis " << axis;
    }
}

TEST(TorusBounds, HoldTheSurfaceTightly) {
    std::mt19937_64 engine(3);
    const auto random = [&](double from, double to) {
        return from + (to - from) * std::generate_canonical<double, 53>(engine);
    };
    const auto vector = [&] { return glm::dvec3(random(-1, 1), random(-1, 1), random(-1, 1)); };
    for (int i = 0; i < 100; ++i) {
        const TorusInstance torus{random(0, 2),    random(0.01, 2),
                                  20.0 * vector(), glm::angleAxis(random(-7, 7), glm::normalize(vector())),
                                  random(0.1, 5),  0};
        expectTight(torus, "trial " + std::to_string(i));
    }
}

TEST(TorusBounds, HoldSpecialToriTightly) {
    const glm::dquat none(1, 0, 0, 0);
    const glm::dquat quarter = glm::angleAxis(std::numbers::pi / 2, glm::dvec3(1, 0, 0));
    expectTight({1, 0.25, {}, none, 1, 0}, "untouched");
    expectTight({1, 0.001, {}, quarter, 1, 0}, "thin, turned by a quarter");
    expectTight({0, 1, {3, 4, 5}, quarter, 2, 0}, "sphere");
    expectTight({1, 1.5, {}, quarter, 1, 0}, "spindle");
    expectTight({1e-30, 1e-31, {}, none, 1e-5, 0}, "tiny");
    expectTight({1e30, 1e29, {}, none, 1e5, 0}, "huge");
}

TEST(TorusBounds, HoldTheTorusThatTheShaderSees) {
    // Far out, float32 moves the centre by more than a double box would forgive.
    const TorusInstance torus{1, 0.25, {100000.003, -100000.003, 0.1}, glm::dquat(1, 0, 0, 0), 1, 0};
    const Box box = boundsOf(torus);
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = axis < 2 ? 1.25 : 0.25;
        const double centre = static_cast<double>(static_cast<float>(torus.translation[axis]));
        EXPECT_LE(box.minimum[axis], centre - reach) << axis;
        EXPECT_GE(box.maximum[axis], centre + reach) << axis;
    }
}

}  // namespace
}  // namespace raytorus::scene
