// SPDX-License-Identifier: MIT
// PNG from a file, by libpng.
#pragma once

#include "image/image_codec.hpp"

namespace raytorus::image {

/// Every PNG, as decode() and decodeHeader() describe it.
[[nodiscard]] Image decodePngHeader(std::span<const std::byte> bytes, std::string_view name);
[[nodiscard]] Image decodePng(std::span<const std::byte> bytes, std::string_view name);

}  // namespace raytorus::image
