// SPDX-License-Identifier: MIT
#include "viewer/capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/error.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::viewer {

std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& extension) {
    for (int number = 1; number < 100000; ++number) {
        std::filesystem::path path = folder / fmt::format("{}-{:03}{}", stem, number, extension);
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) {
            return path;
        }
    }
    throw Error(ExitCode::File, fmt::format("{}: every number up to 99999 is taken",
                                            (folder / (stem + "-..." + extension)).string()));
}

void writeDisplayed(const std::filesystem::path& path, image::Image displayed) {
    for (float& value : displayed.pixels) {
        const long stored = std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F);
        value = image::decodeSrgb(static_cast<std::uint8_t>(stored));
    }
    image::writeImage(path, displayed);
}

void writeScene(const std::filesystem::path& path, scene::Scene scene, VkExtent2D size) {
    scene.imageWidth = static_cast<int>(size.width);
    scene.imageHeight = static_cast<int>(size.height);
    const std::string text = scene::writeScene(scene);
    writeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace raytorus::viewer
