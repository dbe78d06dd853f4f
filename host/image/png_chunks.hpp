// SPDX-License-Identifier: MIT
// The frame of a PNG file: whether all of it is there and undamaged.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace raytorus::image {

/// What is wrong with the chunks of a PNG file, as the end of a sentence, or nothing. Every chunk must be
/// whole, have the right checksum, and the last must be IEND: libpng is content with a file that was cut
/// after its last row, and reports the rest on stderr behind our back.
[[nodiscard]] std::string pngProblem(std::span<const std::byte> bytes);

}  // namespace raytorus::image
