// SPDX-License-Identifier: MIT
// Images to and from the bytes of an OpenEXR or PNG file, in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace raytorus::image {

enum class Format { Exr, Png };

/// The bytes of a file. The same image gives the same bytes: no date, no host, no program name is stored.
/// `name` is what errors call the image.
///
/// OpenEXR: every channel by name, 32 bit float, zip; all bits come back, those of NaN included.
///
/// PNG: 8 bit, channels R, G, B and, where there is one, A; others are left out. Colour is taken as linear
/// light, clamped to [0,1] and sRGB-encoded; it is not divided by alpha. Alpha is clamped and stored without
/// a curve. Throws NonFinite when one of these channels holds NaN or an infinity, File when R, G or B is not
/// there.
[[nodiscard]] std::vector<std::byte> encode(const Image& image, Format format, std::string_view name);

/// The image in the bytes of a file without its pixels, of which it has none: width, height, channels and
/// sample type. Takes little memory, whatever the bytes say. Throws as decode() does, as far as it reads.
[[nodiscard]] Image decodeHeader(std::span<const std::byte> bytes, Format format, std::string_view name);

/// The image in the bytes of a file. Throws File when they are damaged, incomplete, or more than a plain
/// image: several parts, deep pixels, integer channels, or a data window that is not the display window.
/// `sampleType` is that of the file, float16 when any of its channels is.
/// Channels come as R, G, B, A (those that exist), then the others sorted by the bytes of their names.
/// An image over the limits of image.hpp is refused before it takes memory, and no more is taken than there
/// are pixels in the bytes, whatever their header says.
/// PNG: values are as stored, divided by 255 (or 65535): sRGB is not decoded. A grey image has the channel Y.
[[nodiscard]] Image decode(std::span<const std::byte> bytes, Format format, std::string_view name);

}  // namespace raytorus::image
