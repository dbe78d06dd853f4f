// SPDX-License-Identifier: MIT
#include "explain/pixel.hpp"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "scene/pack.hpp"
#include "trace/pixel_ray.hpp"

namespace raytorus::explain {

PixelRay pixelRay(const scene::Scene& scene, int width, int height, int x, int y) {
    const trace::TraceRay camera = trace::cameraRay(scene::makeFrame(scene, width, height), x, y);
    PixelRay result;
    result.x = x;
    result.y = y;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const scene_io::SceneTorus placed = scene::makeTorus(scene.tori[i], i);
        const reference::Torus torus{placed.radii.x, placed.radii.y};
        const auto ray = std::bit_cast<reference::Ray>(trace::rayInFrame(placed, camera));
        const reference::Intersections found = reference::intersect(torus, ray);
        const bool hit = found.count > 0;
        const double distance = hit ? reference::toDouble(found.hits[0].t)
                                    : found.clearance * static_cast<double>(torus.minorRadius);
        if (i == 0 || (hit && !result.hits) || (hit == result.hits && distance < nearest)) {
            result.torus = torus;
            result.ray = ray;
            result.hits = hit;
            result.index = i;
            nearest = distance;
        }
    }
    result.sentence = fmt::format(
        "torus {}, which the ray {}", result.index,
        result.hits ? "hits first" : fmt::format("misses by {:.3g}, all others by more", nearest));
    return result;
}

}  // namespace raytorus::explain
