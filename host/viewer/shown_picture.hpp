// SPDX-License-Identifier: MIT
// The picture as the window shows it: drawn, worked out, coloured by the view, and each of these again when
// something has changed that it depends on.
#pragma once

#include <filesystem>
#include <string>
#include <tuple>

#include "viewer/frame.hpp"
#include "viewer/inspection.hpp"
#include "viewer/pictures.hpp"
#include "viewer/state.hpp"
#include "viewer/view_pass.hpp"

namespace raytorus::viewer {

class ShownPicture {
public:
    /// context and log are kept by reference. linear: the window turns linear values into sRGB by itself.
    ShownPicture(gpu::Context& context, const EventLog& log, VkExtent2D window, bool linear);

    /// See Inspection.
    void openGolden(const std::string& file, const std::filesystem::path& scene);

    /// Draws for a while towards what the state asks for. now: by the loop's clock. still: nothing is going
    /// to move. A driver that refuses edited shaders is told in the state's shaderError.
    void draw(State& state, VkExtent2D window, double now, bool still);
    /// Works on what the view shows of the picture.
    void inspect(State& state);
    /// Colours the picture as the view does, if it has to be. True: what is seen is another.
    bool color(const State& state);
    /// The time is another, and so may be the picture.
    void renew() { stale = true; }

    /// Nothing is left to be drawn.
    [[nodiscard]] bool settled() const { return pictures.settled(); }
    /// Nor to be worked out or coloured.
    [[nodiscard]] bool complete(const State& state) const {
        return settled() && !stale && inspection.complete(state);
    }
    /// Something is left to be done at once.
    [[nodiscard]] bool busy() const { return pictures.drawing() || stale; }

    /// The picture was made small for speed.
    [[nodiscard]] bool moving() const { return pictures.shown() == Quality::Moving; }
    /// What showing a moving picture takes, besides the last draw(). seconds: both together.
    void learnRound(double seconds) { pictures.learnShowing(seconds - drawingSeconds); }

    [[nodiscard]] FramePicture framePicture(const State& state) const;
    /// Where in the window it is seen.
    [[nodiscard]] VkRect2D place(const State& state, VkExtent2D window) const;
    /// Of the whole picture.
    [[nodiscard]] VkExtent2D size() const { return pictures.size(); }

    /// The left side into an .exr file with every channel, or the picture into a .png as the view shows it.
    void write(const std::filesystem::path& path, PictureView view);
    /// See Inspection.
    [[nodiscard]] Pick takeApart(const TakeApart& pixel, const State& state,
                                 const std::string& deviceWords) const;

private:
    void noteDrawn(State& state);
    void noteLooks(const State& state);
    [[nodiscard]] view_io::ViewPush viewPush(const State& state) const;

    const EventLog* log;
    Pictures pictures;
    ViewPass viewPass;
    Inspection inspection;
    bool linear;
    bool stale = true;  // the view is not that of the pictures
    double drawingSeconds = 0.0;
    std::tuple<PictureView, double, int> lastLooks{PictureView::Shaded, -1.0, 0};
};

}  // namespace raytorus::viewer
