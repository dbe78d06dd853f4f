// SPDX-License-Identifier: MIT
// What all who read image files do alike: the words for failing, the signature, the order of channels.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image_codec.hpp"

namespace raytorus::image {

[[noreturn]] void failReading(std::string_view name, std::string_view reason);
[[noreturn]] void failWriting(std::string_view name, std::string_view reason);

/// A library's message as a part of one sentence: its first line, without the full stop, and without what a
/// terminal would obey.
[[nodiscard]] std::string oneLine(std::string message);

/// Throws Error{File} unless the bytes begin as a file of this format does.
void checkSignature(std::span<const std::byte> bytes, Format format, std::string_view name);

/// R, G, B, A first, then by name: the places of a file's channels, whose order is its own.
[[nodiscard]] std::vector<std::size_t> documentedOrder(std::span<const std::string> names);

/// An image that is filled from its first pixel to its last. Memory is taken as pixels come, so that a header
/// alone takes none.
class ImageFill {
public:
    /// As a file's header says: the channels in the file's order. The shape has no problem (image.hpp).
    ImageFill(int width, int height, std::span<const std::string> names, SampleType sampleType);

    /// Whole pixels, interleaved in the file's order of channels.
    void append(std::span<const float> values);

    /// What there is of it, at the end.
    [[nodiscard]] Image take() { return std::move(image); }

private:
    Image image;
    std::vector<std::size_t> order;
};

/// The rows that are decoded at a time: a multiple of `step`, all if there are fewer.
[[nodiscard]] int rowsAtATime(int width, int height, std::size_t channels, int step);

}  // namespace raytorus::image
