// SPDX-License-Identifier: MIT
// The viewer: what its command line asks for, and its window.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "options/device_options.hpp"
#include "render/picture_drawing.hpp"
#include "viewer/script.hpp"
#include "viewer/state.hpp"
#include "viewer/view_list.hpp"

namespace raytorus::viewer {

inline constexpr const char* programName = "raytorus-view";

struct ViewerOptions {
    std::string scene;
    int width = 0;  ///< of the window, in its own units; 0: the scene's picture
    int height = 0;
    PictureView view = PictureView::Shaded;
    std::string method;  ///< empty: the edited shaders, or the library
    render::Route route = render::Route::Fragment;
    std::string wipeMethod;  ///< empty: no wipe
    double wipeAt = 0.5;
    int samplesPerSide = 2;
    std::string golden;
    std::string edit;  ///< a folder of GLSL
    double time = 0.0;
    bool paused = false;
    bool panel = true;
    bool help = false;
    std::optional<std::pair<int, int>> pick;
    Script script;  ///< of nothing: until the window is closed
    bool events = false;
    options::DeviceOptions device;
};

/// Nothing where --help, --version or a list has been answered. Throws Error{Usage}.
std::optional<ViewerOptions> parseOptions(const std::vector<std::string>& arguments);

/// What the window shows at first. Throws Error.
State firstState(const ViewerOptions& options);

/// Opens the window and returns when it is closed. Throws Error.
void runViewer(const ViewerOptions& options);

}  // namespace raytorus::viewer
