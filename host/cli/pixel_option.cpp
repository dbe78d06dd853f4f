// SPDX-License-Identifier: MIT
#include "cli/pixel_option.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "options/number_text.hpp"
#include "options/option_text.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::cli {
namespace {

std::pair<int, int> pixelOf(const std::string& text, int width, int height) {
    const auto numbers = options::parsePair(text);
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

explain::PixelRay pixelRay(const std::string& scenePath, const std::string& pixel, const std::string& size) {
    const scene::Scene scene = scene::readScene(scenePath);
    const auto [width, height] =
        size.empty() ? std::pair(scene.imageWidth, scene.imageHeight) : options::sizeOption(size);
    const auto [x, y] = pixelOf(pixel, width, height);
    explain::PixelRay result = explain::pixelRay(scene, width, height, x, y);
    result.sentence = fmt::format("pixel ({}, {}) of {}: {}", x, y, scenePath, result.sentence);
    return result;
}

}  // namespace raytorus::cli
