// SPDX-License-Identifier: MIT
// PNG files by libpng itself: writing one needs three libraries where OpenImageIO needs 250.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace raytorus::image {

/// encode() for Format::Png, of an image that has a proper shape.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image, std::string_view name);

}  // namespace raytorus::image
