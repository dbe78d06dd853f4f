// SPDX-License-Identifier: MIT
// What the viewer shows and how, as plain data: keys and panels change it, the loop draws it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/picture_drawing.hpp"
#include "scene/scene.hpp"
#include "viewer/method_list.hpp"
#include "viewer/view_list.hpp"

namespace raytorus::viewer {

/// Who draws a side of the picture.
struct Side {
    std::size_t method = 0;  ///< of State::methods
    render::Route route = render::Route::Fragment;

    bool operator==(const Side&) const = default;
};

struct Animation {
    bool playing = true;
    double seconds = 0.0;  ///< of the scene's own time
    double speed = 1.0;
};

struct Message {
    std::string text;
    double until = 0.0;  ///< by the loop's clock
};

/// What the panel shows of the last pictures.
struct PictureStatistics {
    VkExtent2D extent{};       ///< of the picture that is shown
    int samples = 1;           ///< a pixel
    double drawSeconds = 0.0;  ///< of the last complete drawing
    double deviceSeconds = 0.0;
    bool compiled = false;  ///< within that time, by the driver
    double framesPerSecond = 0.0;
    double analysed = 0.0;  ///< part of the pixels whose reference is known
    long long wrongPixels = 0;
    double largestError = 0.0;  ///< in units, see Analysis
};

/// A pixel that has been taken apart.
struct Pick {
    int x = 0;
    int y = 0;
    std::string text;      ///< what `raytorus explain` says
    std::string command;   ///< that prints the same
    std::string testCase;  ///< ray and torus as C++
};

struct State {
    std::string sceneFile;
    scene::Scene fileScene;  ///< as it was read
    scene::Scene scene;      ///< as it is edited; its camera is the one that is moved

    PictureView view = PictureView::Shaded;
    std::vector<MethodEntry> methods;
    Side left;
    Side right{1, render::Route::Fragment};
    bool wipe = false;
    double wipeAt = 0.5;  ///< part of the width

    Animation animation;
    int samplesPerSide = 2;  ///< at rest
    int mostSteps = 32;      ///< white in the view of steps

    bool panel = true;
    bool help = false;
    std::size_t selectedTorus = 0;

    PictureStatistics statistics;
    std::optional<Pick> pick;
    std::string goldenSentence;  ///< what the comparison with the golden picture comes to

    std::string shaderError;  ///< while the edited shaders do not compile
    Message message;
};

/// Whether time changes the scene.
inline bool isAnimated(const State& state) {
    return state.scene.turntable.has_value();
}

}  // namespace raytorus::viewer
