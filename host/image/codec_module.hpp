// SPDX-License-Identifier: MIT
// The modules that image_codec.cpp loads at need for EXR files, and what each of them has in it.
#pragma once

#include <string>

#include "image/image_codec.hpp"

namespace raytorus::image {

/// All three for OpenEXR, as encode(), decodeHeader() and decode() describe them.
struct Codec {
    std::vector<std::byte> (*encode)(const Image& image, std::string_view name);
    Image (*decodeHeader)(std::span<const std::byte> bytes, std::string_view name);
    Image (*decode)(std::span<const std::byte> bytes, std::string_view name);
};

inline constexpr const char* openImageIoModule = "raytorus-openimageio.so";
inline constexpr const char* openExrModule = "raytorus-openexr.so";
inline constexpr const char* codecSymbol = "raytorusCodec";

/// Null where the module cannot be loaded; `problem` is then why, in the loader's words, which name the file.
[[nodiscard]] const Codec* loadCodec(const char* module, std::string& problem);

}  // namespace raytorus::image

extern "C" const raytorus::image::Codec* raytorusCodec();
