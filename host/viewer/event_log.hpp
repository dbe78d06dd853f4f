// SPDX-License-Identifier: MIT
// What happens in the window, as a line of JSON each on standard output: for programs that drive it.
#pragma once

#include <vulkan/vulkan.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "viewer/state.hpp"

namespace raytorus::viewer {

class EventLog {
public:
    using Value = std::variant<bool, long long, double, std::string, std::vector<double>>;
    using Field = std::pair<std::string_view, Value>;

    /// Silent unless enabled.
    explicit EventLog(bool enabled) : on(enabled) {}

    /// {"event": "<name>", ...}, written at once.
    void write(std::string_view name, std::initializer_list<Field> fields = {}) const;

private:
    bool on;
};

/// Tells what hands have changed, for programs that drive the window and wait for what they have done.
class ChangeLog {
public:
    /// Writes an event for each of these that is not as it was at the last call, and all of them at the
    /// first:
    ///   camera  position, target, up
    ///   method  left, right, leftRoute, rightRoute
    ///   wipe    on, at (part of the width)
    ///   samples side (of the grid of samples a pixel)
    ///   time    seconds, playing, speed; not while it goes on by itself
    ///   shown   panel, help, pixel: which of them are open
    ///   focus   panel: the keys go there
    void note(const State& state, bool panelTakesKeys, const EventLog& log);

    /// Writes the event size, and returns true, if the window's is not that of the last call.
    bool noteSize(VkExtent2D size, const EventLog& log);

private:
    struct Seen {
        scene::Camera camera;
        Side left, right;
        bool wipe;
        double wipeAt;
        int samplesPerSide;
        Animation animation;
        bool panel, help, pixel, focus;
    };

    std::optional<Seen> seen;
    VkExtent2D seenSize{};
};

/// Counts frames, and tells of those with moving pictures once a second.
class RateLog {
public:
    /// A frame has been shown. now: by the loop's clock. moving: its picture was made small for speed.
    void noteFrame(double now, bool moving, PictureStatistics& statistics, const EventLog& log);

private:
    double lastFrame = 0.0;
    int movedFrames = 0;  // that have not been told of
    double movedSeconds = 0.0;
};

}  // namespace raytorus::viewer
