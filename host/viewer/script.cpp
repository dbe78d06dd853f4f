// SPDX-License-Identifier: MIT
#include "viewer/script.hpp"

#include <algorithm>
#include <utility>

#include "viewer/frame.hpp"

namespace raytorus::viewer {

ScriptDriver::ScriptDriver(Script asked) : wanted(std::move(asked)) {}

bool ScriptDriver::drives() const {
    return wanted.frames > 0 || !wanted.sequence.empty() || !wanted.screenshot.empty() ||
           !wanted.windowScreenshot.empty();
}

bool ScriptDriver::wantsWindow(bool complete) const {
    return !wanted.windowScreenshot.empty() && complete && framesShown >= settlingFrames &&
           framesShown + 1 >= wanted.frames;
}

void ScriptDriver::drive(bool complete, double seconds, CommandQueue& commands) {
    const bool windowMissing = !wanted.windowScreenshot.empty() && !windowWritten;
    if (!drives() || !complete || windowMissing || framesShown < std::max(wanted.frames, settlingFrames)) {
        return;
    }
    if (picturesWritten < wanted.sequence.size()) {
        driveSequence(seconds, commands);
        return;
    }
    if (!wanted.screenshot.empty()) {
        commands.push(WritePicture{wanted.screenshot});
    }
    commands.push(Quit{});
}

void ScriptDriver::driveSequence(double seconds, CommandQueue& commands) {
    const options::SequenceFrame& frame = wanted.sequence[picturesWritten];
    if (seconds == frame.seconds) {
        commands.push(WritePicture{frame.output});
        ++picturesWritten;
    }
    if (picturesWritten < wanted.sequence.size()) {
        commands.push(ShowTime{wanted.sequence[picturesWritten].seconds});
    }
}

}  // namespace raytorus::viewer
