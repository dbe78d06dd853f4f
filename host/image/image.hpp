// SPDX-License-Identifier: MIT
// An image in memory: float32, any number of named channels, rows from the top, channels interleaved.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::image {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::string> channelNames;
    std::vector<float> pixels;  ///< width * height * channelNames.size() values

    Image() = default;

    /// A black image. Width and height are positive, names are unique.
    Image(int imageWidth, int imageHeight, std::vector<std::string> names);

    [[nodiscard]] int channelCount() const { return static_cast<int>(channelNames.size()); }

    /// The index of the channel with this name, or -1.
    [[nodiscard]] int channelIndex(std::string_view name) const;

    /// All channels of one pixel. x counts from the left, y from the top.
    [[nodiscard]] std::span<float> pixel(int x, int y);
    [[nodiscard]] std::span<const float> pixel(int x, int y) const;
};

}  // namespace raytorus::image
