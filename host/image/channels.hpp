// SPDX-License-Identifier: MIT
// The channels of pictures, in the one table of them: what each is called and means, where the shaders have
// it, and what of a truth it is held to.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::image {

enum class ChannelKind {
    Color,      ///< linear RGB
    Alpha,      ///< what a PNG has besides
    Geometry,   ///< belongs to the ray through the middle of the pixel, and an EXR alone has it
    Margin,     ///< of a truth: below 1, rounding the ray to float32 may change the values that name it
    Tolerance,  ///< of a truth: what the values that name it may be off, absolutely
};

/// A component of an image that the shaders draw: ScenePixel in shade.glsl has them in this order.
struct DrawnComponent {
    std::size_t image = 0;
    std::size_t component = 0;
};

/// What one or more channels hold together.
struct Quantity {
    std::array<std::string_view, 5> names;  ///< of its channels, and after them empty ones
    ChannelKind kind;
    std::string_view meaning;
    std::string_view onMiss = {};  ///< what it is where nothing is hit. Empty: it belongs to a truth
    DrawnComponent first = {};     ///< of a value: its first channel; the others follow
    /// The channels of a truth that say where a value is open, and what it may be off. Without a margin it is
    /// never open, and without a tolerance it is exact.
    std::string_view margin = {}, tolerance = {};
    bool cyclic = false;  ///< 0 and 1 are the same place

    [[nodiscard]] constexpr std::span<const std::string_view> channels() const {
        std::size_t count = 0;
        while (count < names.size() && !names[count].empty()) {
            ++count;
        }
        return std::span(names).first(count);
    }
    [[nodiscard]] constexpr bool isOfTruth() const {
        return kind == ChannelKind::Margin || kind == ChannelKind::Tolerance;
    }
};

/// In the order of a picture that we make.
inline constexpr std::array quantities = {
    Quantity{{"R", "G", "B"},
             ChannelKind::Color,
             "colour, the mean of all samples",
             "the background",
             {0, 0},
             "margin.color",
             "tolerance.color"},
    Quantity{{"A"}, ChannelKind::Alpha, "1", "1", {0, 3}},
    Quantity{{"t"}, ChannelKind::Geometry, "distance from the camera", "0", {1, 3}, "margin", "tolerance.t"},
    Quantity{{"position.x", "position.y", "position.z"},
             ChannelKind::Geometry,
             "where the surface is hit, in the scene",
             "0",
             {1, 0},
             "margin",
             "tolerance.position"},
    Quantity{{"normal.x", "normal.y", "normal.z"},
             ChannelKind::Geometry,
             "its unit normal, outwards",
             "0",
             {2, 0},
             "margin",
             "tolerance.normal"},
    Quantity{{"uv.u", "uv.v"},
             ChannelKind::Geometry,
             "its coordinates round the axis and round the tube, 0 to 1",
             "0",
             {3, 0},
             "margin",
             "tolerance.uv",
             true},
    Quantity{
        {"count"}, ChannelKind::Geometry, "number of surfaces on the whole ray", "0", {2, 3}, "margin.count"},
    Quantity{
        {"id"}, ChannelKind::Geometry, "place of the torus in the scene, from 0", "-1", {3, 2}, "margin"},
    Quantity{{"margin"},
             ChannelKind::Margin,
             "how far the nearest hit (hit or miss, which torus, which crossing) is from flipping"},
    Quantity{{"margin.count"}, ChannelKind::Margin, "how far the number of surfaces on the ray is"},
    Quantity{{"margin.color"},
             ChannelKind::Margin,
             "how far the colour is: the nearest hit of any sample, the edges of checker and shadows"},
    Quantity{{"tolerance.color", "tolerance.t", "tolerance.position", "tolerance.normal", "tolerance.uv"},
             ChannelKind::Tolerance,
             "how far a value may be off, each of its components, where the margin is at least 1"},
};

/// The quantity that a channel belongs to, or nothing.
[[nodiscard]] const Quantity* findQuantity(std::string_view channel);

/// All channels of these kinds, in the order of the table.
[[nodiscard]] std::vector<std::string> channelsOf(std::initializer_list<ChannelKind> kinds);

}  // namespace raytorus::image
