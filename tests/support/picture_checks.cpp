// SPDX-License-Identifier: MIT
#include "picture_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/intersect.hpp"

namespace raytorus::test {
namespace {

struct Miss {
    double distance;  // from the surface, in world units
    double allowed;
};

// Of a point from a placed torus.
Miss missOf(const scene::TorusInstance& torus, const glm::dvec3& point) {
    const glm::dvec3 local = glm::conjugate(torus.rotation) * (point - torus.translation) / torus.scale;
    const reference::BasicTorus<double> shape{torus.majorRadius, torus.minorRadius};
    const double distance = torus.scale * reference::tubeDistance(shape, {local.x, local.y, local.z});
    // The hit's own rounding, the rotation's three products and their sums, the translation and its sum:
    // eight roundings of lengths up to this.
    const double size =
        torus.scale * (torus.majorRadius + torus.minorRadius) + glm::length(torus.translation);
    return {std::abs(distance), 8 * 0x1p-24 * size};
}

}  // namespace

std::string offTheTori(const image::Image& picture, const scene::Scene& scene) {
    const auto channel = [&picture](const char* name) {
        return static_cast<std::size_t>(picture.channelIndex(name));
    };
    const std::size_t id = channel("id");
    const std::size_t x = channel("position.x"), y = channel("position.y"), z = channel("position.z");
    int hits = 0;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const std::span<const float> pixel = picture.pixel(column, row);
            if (!(pixel[id] >= 0.0F)) {
                continue;
            }
            ++hits;
            const Miss miss =
                missOf(scene.tori.at(static_cast<std::size_t>(pixel[id])), {pixel[x], pixel[y], pixel[z]});
            if (!(miss.distance <= miss.allowed)) {
                return fmt::format("pixel ({}, {}) is {:.3g} off torus {}, {:.3g} is allowed", column, row,
                                   miss.distance, pixel[id], miss.allowed);
            }
        }
    }
    return hits > 0 ? "" : "no pixel shows a torus";
}

}  // namespace raytorus::test
