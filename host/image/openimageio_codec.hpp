// SPDX-License-Identifier: MIT
// What image_codec.cpp finds in the module that is linked with OpenImageIO.
#pragma once

#include "image/image_codec.hpp"

namespace raytorus::image {

struct Codec {
    std::vector<std::byte> (*encodeExr)(const Image& image, std::string_view name);
    Image (*decode)(std::span<const std::byte> bytes, Format format, std::string_view name);
};

inline constexpr const char* codecModule = "raytorus-openimageio.so";
inline constexpr const char* codecSymbol = "raytorusCodec";

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec raytorusCodec;
