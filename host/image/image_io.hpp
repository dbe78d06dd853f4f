// SPDX-License-Identifier: MIT
// Image files. What each format keeps and how it is encoded is told in image_codec.hpp.
#pragma once

#include <filesystem>

#include "image/image.hpp"

namespace raytorus::image {

/// Reads an .exr or .png file. Throws Error{ExitCode::File} when it is missing, not readable, damaged, or
/// more than a plain image. A file that was cut off is an error, never an image in part.
[[nodiscard]] Image readImage(const std::filesystem::path& path);

/// Writes an .exr or .png file, chosen by its extension, in one step: after an error nothing half written is
/// left. Throws Error{ExitCode::File}, or Error{ExitCode::NonFinite} for a PNG with NaN or infinity.
void writeImage(const std::filesystem::path& path, const Image& image);

/// Whether writeImage() knows the extension, so that a program can refuse a name before it works.
[[nodiscard]] bool hasImageExtension(const std::filesystem::path& path);

}  // namespace raytorus::image
