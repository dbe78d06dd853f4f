// SPDX-License-Identifier: MIT
// Image files. What each format keeps and how it is encoded is told in image_codec.hpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "image/image.hpp"
#include "image/image_codec.hpp"

namespace raytorus::image {

/// Reads an .exr or .png file. Throws Error{ExitCode::File} when it is missing, not readable, damaged, or
/// more than a plain image. A file that was cut off is an error, never an image in part.
[[nodiscard]] Image readImage(const std::filesystem::path& path);

/// An image file of which the pixels are read when they are asked for.
class ImageFile {
public:
    /// Throws as readImage().
    explicit ImageFile(std::filesystem::path path);

    /// All but the pixels, of which it has none.
    [[nodiscard]] const Image& header() const { return head; }

    /// Throws as readImage().
    [[nodiscard]] Image read() const;

private:
    std::filesystem::path file;
    std::vector<std::byte> bytes;
    Image head;
};

/// Writes an .exr or .png file, chosen by its extension, in one step: after an error nothing half written is
/// left. Throws Error{ExitCode::File}, or Error{ExitCode::NonFinite} for a PNG with NaN or infinity.
void writeImage(const std::filesystem::path& path, const Image& image);

/// Whether writeImage() knows the extension, so that a program can refuse a name before it works.
[[nodiscard]] bool hasImageExtension(const std::filesystem::path& path);
/// The same for this format alone.
[[nodiscard]] bool hasImageExtension(const std::filesystem::path& path, Format format);

}  // namespace raytorus::image
