// SPDX-License-Identifier: MIT
// The views: what the window can show of a picture.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "viewer/view_io.h"

namespace raytorus::viewer {

enum class PictureView : std::uint32_t {
    Shaded = VIEW_SHADED,
    Normal = VIEW_NORMAL,
    Uv = VIEW_UV,
    Depth = VIEW_DEPTH,
    Count = VIEW_COUNT,
    Torus = VIEW_TORUS,
    Steps = VIEW_STEPS,
    Surface = VIEW_SURFACE,
    Reference = VIEW_REFERENCE,
    Golden = VIEW_GOLDEN,
};

struct ViewInfo {
    PictureView view;
    const char* name;         ///< for --view
    const char* title;        ///< in the panel
    const char* description;  ///< what its colours mean
};

std::span<const ViewInfo> views();

const ViewInfo& infoOf(PictureView view);

/// The view with this name, or null.
const ViewInfo* findView(std::string_view name);

/// A line a view, as `--list-views` prints them.
std::string viewTable();

/// Whether the view needs t, normals and the like, or the colour alone.
constexpr bool needsAovs(PictureView view) {
    return view != PictureView::Shaded;
}

/// Whether the view shows what the host works out about a picture.
constexpr bool needsAnalysis(PictureView view) {
    return view == PictureView::Surface || view == PictureView::Reference || view == PictureView::Golden;
}

}  // namespace raytorus::viewer
