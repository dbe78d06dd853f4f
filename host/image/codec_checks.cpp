// SPDX-License-Identifier: MIT
#include "image/codec_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "core/error.hpp"
#include "image/channels.hpp"

namespace raytorus::image {

namespace {

const char* formatName(Format format) {
    return format == Format::Exr ? "OpenEXR" : "PNG";
}

}  // namespace

void failReading(std::string_view name, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot read \"{}\": {}", name, reason));
}

void failWriting(std::string_view name, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot write \"{}\": {}", name, reason));
}

std::string oneLine(std::string message) {
    message.resize(std::min(message.size(), message.find('\n')));
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) {
        message.pop_back();
    }
    std::ranges::replace_if(
        message, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return message.empty() ? "no reason given" : message;
}

void checkSignature(std::span<const std::byte> bytes, Format format, std::string_view name) {
    constexpr std::array<unsigned char, 4> exr = {0x76, 0x2f, 0x31, 0x01};
    constexpr std::array<unsigned char, 8> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const std::span<const unsigned char> signature =
        format == Format::Exr ? std::span<const unsigned char>(exr) : std::span<const unsigned char>(png);
    if (bytes.empty()) {
        failReading(name, "it is empty");
    }
    if (bytes.size() < signature.size() ||
        !std::ranges::equal(bytes.first(signature.size()), std::as_bytes(signature))) {
        failReading(name, fmt::format("it is not an image in the {} format", formatName(format)));
    }
}

std::vector<std::size_t> documentedOrder(std::span<const std::string> names) {
    const std::vector<std::string> first = channelsOf({ChannelKind::Color, ChannelKind::Alpha});
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto rank = [&](std::size_t channel) {
        const auto place = std::ranges::find(first, names[channel]) - first.begin();
        return std::tuple(place, std::string_view(names[channel]));
    };
    std::ranges::sort(order, {}, rank);
    return order;
}

ImageFill::ImageFill(int width, int height, std::span<const std::string> names, SampleType sampleType)
    : order(documentedOrder(names)) {
    image.width = width;
    image.height = height;
    image.sampleType = sampleType;
    for (const std::size_t channel : order) {
        image.channelNames.push_back(names[channel]);
    }
}

void ImageFill::append(std::span<const float> values) {
    // All at once: an image that grew would be copied again and again. What is not used takes no memory.
    image.pixels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                         order.size());
    const std::size_t begin = image.pixels.size();
    image.pixels.resize(begin + values.size());
    for (std::size_t first = 0; first < values.size(); first += order.size()) {
        for (std::size_t channel = 0; channel < order.size(); ++channel) {
            image.pixels[begin + first + channel] = values[first + order[channel]];
        }
    }
}

int rowsAtATime(int width, int height, std::size_t channels, int step) {
    constexpr std::size_t valuesAtATime = std::size_t{1} << 22U;
    const std::size_t rows = valuesAtATime / (static_cast<std::size_t>(width) * channels);
    const std::size_t whole = std::max<std::size_t>(rows / static_cast<std::size_t>(step), 1);
    return static_cast<int>(
        std::min(whole * static_cast<std::size_t>(step), static_cast<std::size_t>(height)));
}

}  // namespace raytorus::image
