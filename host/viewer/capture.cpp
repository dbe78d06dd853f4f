// SPDX-License-Identifier: MIT
#include "viewer/capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"

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

namespace {

image::Image colorsOf(const image::Image& picture) {
    image::Image colors(picture.width, picture.height, {"R", "G", "B", "A"});
    const auto channels = static_cast<std::size_t>(picture.channelCount());
    for (std::size_t i = 0; i < colors.pixels.size(); ++i) {
        colors.pixels[i] = picture.pixels[i / 4 * channels + i % 4];
    }
    return colors;
}

}  // namespace

void writePicture(const std::filesystem::path& path, View view, Pictures& pictures, ViewPass& viewPass) {
    if (path.extension() == ".exr") {
        image::writeImage(path, pictures.side(0).readBack(pictures.extent()));
    } else if (view == View::Shaded && !pictures.hasRight()) {
        // From the linear colours themselves, so that it is the PNG that render writes.
        image::writeImage(path, colorsOf(pictures.side(0).readBack(pictures.extent())));
    } else {
        writeDisplayed(path, viewPass.readBack());
    }
}

}  // namespace raytorus::viewer
