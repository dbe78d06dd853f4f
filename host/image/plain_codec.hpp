// SPDX-License-Identifier: MIT
// Image files without OpenImageIO, which is far larger than all else: the kinds that raytorus itself writes
// and a few more, for where the module with it is not.
#pragma once

#include "image/image_codec.hpp"

namespace raytorus::image::plain {

/// The same bytes as OpenImageIO's, as encode() describes them.
[[nodiscard]] std::vector<std::byte> encodeExr(const Image& image, std::string_view name);

/// One image in rows, not compressed or by zip, of channels that are float32 or float16. What is more than
/// that is an Error{File} that says so.
[[nodiscard]] Image decodeExr(std::span<const std::byte> bytes, std::string_view name);

/// Every PNG.
[[nodiscard]] Image decodePng(std::span<const std::byte> bytes, std::string_view name);

}  // namespace raytorus::image::plain
