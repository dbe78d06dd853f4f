// SPDX-License-Identifier: MIT
// The modules that image_codec.cpp loads at need, and what each of them has in it.
#pragma once

#include "image/image_codec.hpp"

namespace raytorus::image {

struct Codec {
    std::vector<std::byte> (*encodeExr)(const Image& image, std::string_view name);
    Image (*decode)(std::span<const std::byte> bytes, Format format, std::string_view name);
};

inline constexpr const char* openImageIoModule = "raytorus-openimageio.so";
inline constexpr const char* openExrModule = "raytorus-openexr.so";
inline constexpr const char* codecSymbol = "raytorusCodec";

/// Null where the module, or a library of it, is not.
[[nodiscard]] const Codec* loadCodec(const char* module);

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec* raytorusCodec();
