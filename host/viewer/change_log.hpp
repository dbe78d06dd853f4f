// SPDX-License-Identifier: MIT
// What hands have changed, told as events: for programs that drive the window and wait for what they have
// done.
#pragma once

#include <optional>
#include <vector>

#include "viewer/event_log.hpp"
#include "viewer/method_list.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

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
    void note(const State& state, const std::vector<MethodEntry>& methods, bool panelTakesKeys,
              const EventLog& log);

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
};

}  // namespace raytorus::viewer
