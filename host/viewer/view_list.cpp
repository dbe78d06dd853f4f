// SPDX-License-Identifier: MIT
#include "viewer/view_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raytorus::viewer {
namespace {

constexpr std::array<ViewInfo, 10> list = {{
    {PictureView::Shaded, "shaded", "Shaded", "the picture, as raytorus render makes it"},
    {PictureView::Normal, "normal", "Normal",
     "the unit normal, from -1 (dark) to 1 (bright) in x, y, z as red, green, blue"},
    {PictureView::Uv, "uv", "UV", "u as red, v as green, under a chessboard of 24 x 12 fields"},
    {PictureView::Depth, "depth", "Depth",
     "t, from the nearest (white) to the farthest point of the scene (black)"},
    {PictureView::Count, "count", "Surfaces",
     "how many surfaces the whole ray crosses: 2 indigo, 4 teal, more yellow; odd green"},
    {PictureView::Torus, "torus", "Torus", "which torus is hit, a colour each"},
    {PictureView::Steps, "steps", "Steps",
     "steps of the solver's loops for the pixel's ray, over all tori: a heat map"},
    {PictureView::Surface, "surface", "Distance from surface",
     "how far the hit is from the surface, in roundings (2^-24 of the torus' size and place)"},
    {PictureView::Reference, "reference", "Difference to reference",
     "how far the hit is from the 104-bit reference's, in the same roundings; magenta: hit and miss, torus "
     "or "
     "number of surfaces differ"},
    {PictureView::Golden, "golden", "Difference to golden",
     "the golden picture's comparison: black equal, blue tolerated, orange to white wrong, green a flip"},
}};

}  // namespace

std::span<const ViewInfo> views() {
    return list;
}

const ViewInfo& infoOf(PictureView view) {
    return list[static_cast<std::size_t>(view)];
}

const ViewInfo* findView(std::string_view name) {
    const auto found = std::ranges::find_if(list, [&](const ViewInfo& info) { return info.name == name; });
    return found == list.end() ? nullptr : &*found;
}

std::string viewTable() {
    std::string text;
    for (const ViewInfo& info : list) {
        text += fmt::format("{:10} {}\n", info.name, info.description);
    }
    return text;
}

}  // namespace raytorus::viewer
