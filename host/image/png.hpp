// SPDX-License-Identifier: MIT
// PNG files by libpng itself: OpenImageIO needs 250 libraries where this needs three.
#pragma once

#include "image/image_codec.hpp"

namespace raytorus::image {

/// encode() for Format::Png, of an image that has a proper shape.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image, std::string_view name);

/// Every PNG, as decode() and decodeHeader() describe it.
[[nodiscard]] Image decodePng(std::span<const std::byte> bytes, std::string_view name);
[[nodiscard]] Image decodePngHeader(std::span<const std::byte> bytes, std::string_view name);

}  // namespace raytorus::image
