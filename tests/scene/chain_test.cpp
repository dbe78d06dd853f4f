// SPDX-License-Identifier: MIT
// The shipped chain is one: neighbours interlock, and no two links touch.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "scene/scene_json.hpp"

namespace raytorus::scene {
namespace {

/// The point of a link's centre circle, and of its disk where the factor is below 1.
glm::dvec3 onCircle(const TorusInstance& link, double angle) {
    const double radius = link.scale * link.majorRadius;
    return link.translation +
           link.rotation * glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
}

double tubeRadius(const TorusInstance& link) {
    return link.scale * link.minorRadius;
}

glm::dvec3 inFrameOf(const TorusInstance& link, const glm::dvec3& point) {
    return glm::conjugate(link.rotation) * (point - link.translation);
}

/// A lower bound of the distance between the surfaces: the circle of a is sampled, the distance to b's is
/// exact.
double clearance(const TorusInstance& a, const TorusInstance& b) {
    constexpr int samples = 2000;
    const double step = 2 * std::numbers::pi / samples;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < samples; ++i) {
        const glm::dvec3 point = inFrameOf(b, onCircle(a, step * i));
        nearest =
            std::min(nearest, std::hypot(std::hypot(point.x, point.y) - b.scale * b.majorRadius, point.z));
    }
    const double betweenSamples = step / 2 * a.scale * a.majorRadius;
    return nearest - betweenSamples - tubeRadius(a) - tubeRadius(b);
}

/// How often the circle of a runs through the disk of b upwards, less how often downwards.
int linkingNumber(const TorusInstance& a, const TorusInstance& b) {
    constexpr int samples = 2000;
    int crossings = 0;
    glm::dvec3 before = inFrameOf(b, onCircle(a, 0.0));
    for (int i = 1; i <= samples; ++i) {
        const glm::dvec3 after = inFrameOf(b, onCircle(a, 2 * std::numbers::pi * (i % samples) / samples));
        if ((before.z < 0.0) != (after.z < 0.0)) {
            const glm::dvec3 crossing = before + (after - before) * (before.z / (before.z - after.z));
            if (std::hypot(crossing.x, crossing.y) < b.scale * b.majorRadius) {
                crossings += after.z < 0.0 ? -1 : 1;
            }
        }
        before = after;
    }
    return crossings;
}

TEST(Chain, InterlocksNeighboursOnly) {
    const Scene scene = readScene(RAYTORUS_SOURCE_DIR "/scenes/chain.json");
    const std::size_t count = scene.tori.size();
    ASSERT_EQ(count % 2, 0U);
    ASSERT_GE(count, 50U);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            const bool areNeighbours = j == i + 1 || (i == 0 && j == count - 1);
            EXPECT_EQ(std::abs(linkingNumber(scene.tori[i], scene.tori[j])), areNeighbours ? 1 : 0)
                << i << ", " << j;
        }
    }
}

TEST(Chain, LinksDoNotTouch) {
    const Scene scene = readScene(RAYTORUS_SOURCE_DIR "/scenes/chain.json");
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        for (std::size_t j = i + 1; j < scene.tori.size(); ++j) {
            // A hundredth of the tube: visible as a gap from close by.
            EXPECT_GT(clearance(scene.tori[i], scene.tori[j]), 0.01 * tubeRadius(scene.tori[i]))
                << i << ", " << j;
        }
    }
}

}  // namespace
}  // namespace raytorus::scene
