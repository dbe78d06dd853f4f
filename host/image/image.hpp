// SPDX-License-Identifier: MIT
// An image in memory: float32, any number of named channels, rows from the top, channels interleaved.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::image {

/// What the values were in the file that they come from. In memory they are float32 all the same.
enum class SampleType { Float32, Float16, Unsigned8, Unsigned16 };

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::string> channelNames;
    std::vector<float> pixels;  ///< width * height * channelNames.size() values
    SampleType sampleType = SampleType::Float32;

    Image() = default;

    /// A black image. Width and height are positive, names are unique.
    Image(int imageWidth, int imageHeight, std::vector<std::string> names);

    [[nodiscard]] int channelCount() const { return static_cast<int>(channelNames.size()); }

    /// The index of the channel with this name, or -1.
    [[nodiscard]] int channelIndex(std::string_view name) const;

    /// All channels of one pixel. x counts from the left, y from the top.
    [[nodiscard]] std::span<float> pixel(int x, int y);
    [[nodiscard]] std::span<const float> pixel(int x, int y) const;

    /// One value of a channel that there is.
    [[nodiscard]] float& at(int x, int y, std::string_view channel);
    [[nodiscard]] float at(int x, int y, std::string_view channel) const;
};

/// Neither NaN nor infinite. A test of the bits, so that no compiler flag can undo it.
[[nodiscard]] constexpr bool isFinite(float value) {
    constexpr std::uint32_t exponentBits = 0x7f800000u;
    return (std::bit_cast<std::uint32_t>(value) & exponentBits) != exponentBits;
}

// What a readable image may be at most. A damaged header cannot make us ask for more memory than this.
inline constexpr int maxImageSide = 65536;
inline constexpr int maxImageChannels = 256;
inline constexpr std::size_t maxImageValues = std::size_t{1} << 30;  ///< 4 GiB of pixels

/// Why an image cannot have this shape, as the end of a sentence, or nothing when it can.
[[nodiscard]] std::string shapeProblem(int width, int height, std::span<const std::string> channelNames);

}  // namespace raytorus::image
