// SPDX-License-Identifier: MIT
// What keys, panels, gestures and scripts ask for, beyond changes of the state: commands, which wait in a
// queue until they can be served.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace raytorus::viewer {

/// When a command can be served.
enum class Moment {
    AtOnce,
    AtRest,    ///< the picture has all its samples
    Complete,  ///< and all is known about it that the view shows
    Panel,     ///< the panel is being drawn
    Frame,     ///< a frame has been shown
};

struct Quit {
    static constexpr Moment moment = Moment::AtOnce;
};
struct ToggleFullScreen {
    static constexpr Moment moment = Moment::AtOnce;
};
struct Minimise {
    static constexpr Moment moment = Moment::AtOnce;
};
struct OpenScene {
    static constexpr Moment moment = Moment::AtOnce;
    std::string file;
};
/// The scene's and the edited shaders'.
struct ReadFilesAgain {
    static constexpr Moment moment = Moment::AtOnce;
};
/// Under the next free name.
struct SaveScene {
    static constexpr Moment moment = Moment::AtOnce;
};
struct CopyText {
    static constexpr Moment moment = Moment::AtOnce;
    std::string text;
};
struct ShowTime {
    static constexpr Moment moment = Moment::AtOnce;
    double seconds = 0.0;
};
/// As the picture is now: for who has waited until it is complete.
struct WritePicture {
    static constexpr Moment moment = Moment::AtOnce;
    std::filesystem::path file;
};
/// Takes a pixel apart.
struct TakeApart {
    static constexpr Moment moment = Moment::AtRest;
    int x = 0;
    int y = 0;
};
/// Under the next free name.
struct SavePicture {
    static constexpr Moment moment = Moment::Complete;
    std::string extension;
};
/// Gives the keys to the panel.
struct FocusPanel {
    static constexpr Moment moment = Moment::Panel;
};
/// With its panels, under the next free name.
struct SaveWindow {
    static constexpr Moment moment = Moment::Frame;
};

using Command = std::variant<Quit, ToggleFullScreen, Minimise, OpenScene, ReadFilesAgain, SaveScene, CopyText,
                             ShowTime, WritePicture, TakeApart, SavePicture, FocusPanel, SaveWindow>;

class CommandQueue {
public:
    /// Of pixels to be taken apart only the last one waits.
    void push(Command command);

    [[nodiscard]] bool waits(Moment moment) const;

    /// Takes out what waits for the moment, in the order in which it came.
    [[nodiscard]] std::vector<Command> take(Moment moment);

private:
    std::vector<Command> waiting;
};

}  // namespace raytorus::viewer
