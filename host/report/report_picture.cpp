// SPDX-License-Identifier: MIT
// Images made fit to be looked at, as text that a page can hold.
#include "report/report_picture.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "image/channels.hpp"
#include "image/image_codec.hpp"

namespace raytorus::report {

namespace {

struct Range {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
};

Range finiteRange(const image::Image& image, std::size_t channel) {
    Range range;
    for (std::size_t i = channel; i < image.pixels.size(); i += image.channelNames.size()) {
        if (image::isFinite(image.pixels[i])) {
            range.low = std::min(range.low, static_cast<double>(image.pixels[i]));
            range.high = std::max(range.high, static_cast<double>(image.pixels[i]));
        }
    }
    return range;
}

}  // namespace

image::Image displayImage(const image::Image& image, const image::Image& scale) {
    std::array<std::size_t, 3> channels = {0, 0, 0};
    const std::vector<std::string> colourNames = image::channelsOf({image::ChannelKind::Color});
    std::array<int, 3> colour{};
    std::ranges::transform(colourNames, colour.begin(),
                           [&image](const std::string& name) { return image.channelIndex(name); });
    const bool hasColour = std::ranges::min(colour) >= 0;
    Range range{0.0, 1.0};
    if (hasColour) {
        std::ranges::transform(colour, channels.begin(),
                               [](int index) { return static_cast<std::size_t>(index); });
    } else {
        range = finiteRange(scale, 0);
    }
    image::Image shown(image.width, image.height, colourNames);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::span<const float> from = image.pixel(x, y);
            const std::span<float> to = shown.pixel(x, y);
            if (!std::ranges::all_of(channels,
                                     [&](std::size_t channel) { return image::isFinite(from[channel]); })) {
                std::ranges::copy(std::array{1.0f, 0.0f, 1.0f}, to.begin());
                continue;
            }
            std::ranges::transform(channels, to.begin(), [&](std::size_t channel) {
                const double value = from[channel];
                const double part =
                    range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5;
                return static_cast<float>(std::clamp(part, 0.0, 1.0));
            });
        }
    }
    return shown;
}

std::string pngDataUri(const image::Image& image) {
    const std::vector<std::byte> png = image::encode(image, image::Format::Png, "picture in a report");
    std::string text((png.size() + 2) / 3 * 4 + 1, '\0');  // EVP_EncodeBlock ends it with a zero
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                    reinterpret_cast<const unsigned char*>(png.data()), static_cast<int>(png.size()));
    text.pop_back();
    return "data:image/png;base64," + text;
}

}  // namespace raytorus::report
