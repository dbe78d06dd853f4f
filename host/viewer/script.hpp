// SPDX-License-Identifier: MIT
// A viewer without hands: what a script asks for on the command line, and when the window gives it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "options/frame_options.hpp"
#include "viewer/commands.hpp"

namespace raytorus::viewer {

/// What the command line asks for before the window closes by itself.
struct Script {
    int frames = 0;                                ///< to be shown, at least
    std::vector<options::SequenceFrame> sequence;  ///< pictures to be written, one after the other
    std::string screenshot;
    std::string windowScreenshot;
};

/// Drives the window as hands would: it looks at each frame and at the end of each round, and pushes
/// commands.
class ScriptDriver {
public:
    explicit ScriptDriver(Script asked);

    /// Anything was asked for. Then the window closes by itself, each round shows a frame, and a fault is an
    /// error.
    [[nodiscard]] bool drives() const;

    /// Whether the frame that is shown next goes into the script's windowScreenshot. complete: the picture
    /// and all that is worked out about it are there.
    [[nodiscard]] bool wantsWindow(bool complete) const;

    void noteFrame() { ++framesShown; }
    void noteWindowWritten() { windowWritten = true; }

    /// At the end of a round: writes the picture of this moment, goes on to the next, or quits. seconds: the
    /// scene's time that the picture shows.
    void drive(bool complete, double seconds, CommandQueue& commands);

private:
    void driveSequence(double seconds, CommandQueue& commands);

    Script wanted;
    int framesShown = 0;
    bool windowWritten = false;
    std::size_t picturesWritten = 0;  // of the sequence
};

}  // namespace raytorus::viewer
