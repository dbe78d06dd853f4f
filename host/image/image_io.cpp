// SPDX-License-Identifier: MIT
// Image files: the extension chooses the format, the codec does the rest.
#include "image/image_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "image/image_codec.hpp"

namespace raytorus::image {

namespace {

// By extension and not by content: a file that is not what its name says is a mistake worth hearing about.
std::optional<Format> knownFormat(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (extension == ".exr") {
        return Format::Exr;
    }
    if (extension == ".png") {
        return Format::Png;
    }
    return std::nullopt;
}

Format formatOf(const std::filesystem::path& path) {
    if (const std::optional<Format> format = knownFormat(path)) {
        return *format;
    }
    throw Error(ExitCode::File,
                fmt::format("\"{}\" does not say its image format: its name must end in .exr or .png",
                            path.string()));
}

}  // namespace

Image readImage(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = readFile(path);
    return decode(bytes, formatOf(path), path.string());
}

ImageFile::ImageFile(std::filesystem::path path)
    : file(std::move(path)),
      bytes(readFile(file)),
      head(decodeHeader(bytes, formatOf(file), file.string())) {}

Image ImageFile::read() const {
    return decode(bytes, formatOf(file), file.string());
}

void writeImage(const std::filesystem::path& path, const Image& image) {
    writeFile(path, encode(image, formatOf(path), path.string()));
}

bool hasImageExtension(const std::filesystem::path& path) {
    return knownFormat(path).has_value();
}

bool hasImageExtension(const std::filesystem::path& path, Format format) {
    return knownFormat(path) == format;
}

}  // namespace raytorus::image
