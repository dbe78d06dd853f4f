// SPDX-License-Identifier: MIT
#include "cli/pixel_option.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "cli/number_text.hpp"
#include "cli/option_text.hpp"
#include "core/error.hpp"
#include "render/pixel_ray.hpp"
#include "render/scene_json.hpp"

namespace raytorus::cli {
namespace {

std::pair<int, int> pixelOf(const std::string& text, int width, int height) {
    const auto numbers = parsePair(text);
    const auto isPixel = [](float number, int count) {
        return number >= 0.0F && number < static_cast<float>(count) && number == std::floor(number);
    };
    if (!numbers || !isPixel(numbers->first, width) || !isPixel(numbers->second, height)) {
        throw Error(ExitCode::Usage, fmt::format("--pixel takes X,Y from 0,0 to {},{}, not \"{}\"", width - 1,
                                                 height - 1, text));
    }
    return {static_cast<int>(numbers->first), static_cast<int>(numbers->second)};
}

}  // namespace

PixelRay pixelRay(const std::string& scenePath, const std::string& pixel, const std::string& size) {
    const render::Scene scene = render::readScene(scenePath);
    const auto [width, height] =
        size.empty() ? std::pair(scene.imageWidth, scene.imageHeight) : sizeOption(size);
    const auto [x, y] = pixelOf(pixel, width, height);
    const render::TraceRay camera = render::cameraRay(render::makeFrame(scene, width, height), x, y);
    PixelRay result;
    double nearest = std::numeric_limits<double>::infinity();
    bool hits = false;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const scene_io::SceneTorus placed = render::makeTorus(scene.tori[i], i);
        const reference::Torus torus{placed.radii.x, placed.radii.y};
        const auto ray = std::bit_cast<reference::Ray>(render::rayInFrame(placed, camera));
        const reference::Intersections found = reference::intersect(torus, ray);
        const bool hit = found.count > 0;
        const double distance = hit ? reference::toDouble(found.hits[0].t)
                                    : found.clearance * static_cast<double>(torus.minorRadius);
        if (i == 0 || (hit && !hits) || (hit == hits && distance < nearest)) {
            result.torus = torus;
            result.ray = ray;
            nearest = distance;
            hits = hit;
            chosen = i;
        }
    }
    result.sentence =
        fmt::format("pixel ({}, {}) of {}: torus {}, which the ray {}", x, y, scenePath, chosen,
                    hits ? "hits first" : fmt::format("misses by {:.3g}, all others by more", nearest));
    return result;
}

}  // namespace raytorus::cli
