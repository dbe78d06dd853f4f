// SPDX-License-Identifier: MIT
// The shape of an image and access to its pixels.
#include "image/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/error.hpp"

namespace raytorus::image {

namespace {

// Names end up in sentences, tables and pages: what a terminal would obey has no place in them.
bool isPrintable(std::string_view name) {
    return std::ranges::none_of(name, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
}

std::size_t valueOffset(const Image& image, int x, int y) {
    assert(x >= 0 && x < image.width && y >= 0 && y < image.height);
    const auto pixelIndex =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    return pixelIndex * image.channelNames.size();
}

}  // namespace

std::string shapeProblem(int width, int height, std::span<const std::string> channelNames) {
    if (width < 1 || height < 1) {
        return fmt::format("its size {} x {} is not positive", width, height);
    }
    if (width > maxImageSide || height > maxImageSide) {
        return fmt::format("its size {} x {} is over {} pixels a side", width, height, maxImageSide);
    }
    if (channelNames.empty() || channelNames.size() > static_cast<std::size_t>(maxImageChannels)) {
        return fmt::format("it has {} channels, not 1 to {}", channelNames.size(), maxImageChannels);
    }
    const auto values =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channelNames.size();
    if (values > maxImageValues) {
        return fmt::format("its {} x {} pixels of {} channels are over {} values", width, height,
                           channelNames.size(), maxImageValues);
    }
    std::vector<std::string_view> names(channelNames.begin(), channelNames.end());
    std::ranges::sort(names);
    if (const auto twin = std::ranges::adjacent_find(names); twin != names.end()) {
        return fmt::format("it has two channels named \"{}\"", *twin);
    }
    if (names.front().empty()) {
        return "it has a channel without a name";
    }
    if (!std::ranges::all_of(names, isPrintable)) {
        return "the name of a channel has control characters";
    }
    return {};
}

Image::Image(int imageWidth, int imageHeight, std::vector<std::string> names)
    : width(imageWidth), height(imageHeight), channelNames(std::move(names)) {
    if (const std::string problem = shapeProblem(width, height, channelNames); !problem.empty()) {
        throw Error(ExitCode::Internal, fmt::format("an image cannot be made: {}", problem));
    }
    pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channelNames.size());
}

int Image::channelIndex(std::string_view name) const {
    const auto found = std::ranges::find(channelNames, name);
    return found == channelNames.end() ? -1 : static_cast<int>(found - channelNames.begin());
}

std::span<float> Image::pixel(int x, int y) {
    return std::span(pixels).subspan(valueOffset(*this, x, y), channelNames.size());
}

std::span<const float> Image::pixel(int x, int y) const {
    return std::span(pixels).subspan(valueOffset(*this, x, y), channelNames.size());
}

float& Image::at(int x, int y, std::string_view channel) {
    assert(channelIndex(channel) >= 0);
    return pixel(x, y)[static_cast<std::size_t>(channelIndex(channel))];
}

float Image::at(int x, int y, std::string_view channel) const {
    assert(channelIndex(channel) >= 0);
    return pixel(x, y)[static_cast<std::size_t>(channelIndex(channel))];
}

}  // namespace raytorus::image
