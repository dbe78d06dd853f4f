// SPDX-License-Identifier: MIT
#include "viewer/change_log.hpp"

namespace raytorus::viewer {
namespace {

std::vector<double> numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

bool changedByHand(const Animation& before, const Animation& now) {
    const bool jumped = now.playing ? now.seconds < before.seconds : now.seconds != before.seconds;
    return jumped || now.playing != before.playing || now.speed != before.speed;
}

}  // namespace

void ChangeLog::note(const State& state, const std::vector<MethodEntry>& methods, bool panelTakesKeys,
                     const EventLog& log) {
    const Seen now{state.scene.camera,   state.left,      state.right, state.wipe, state.wipeAt,
                   state.samplesPerSide, state.animation, state.panel, state.help, state.pick.has_value(),
                   panelTakesKeys};
    if (!seen || seen->camera != now.camera) {
        log.write("camera", {{"position", numbers(now.camera.position)},
                             {"target", numbers(now.camera.target)},
                             {"up", numbers(now.camera.up)}});
    }
    if (!seen || seen->left != now.left || seen->right != now.right) {
        log.write("method", {{"left", methods[now.left.method].name},
                             {"right", methods[now.right.method].name},
                             {"leftRoute", render::infoOf(now.left.route).name},
                             {"rightRoute", render::infoOf(now.right.route).name}});
    }
    if (!seen || seen->wipe != now.wipe || seen->wipeAt != now.wipeAt) {
        log.write("wipe", {{"on", now.wipe}, {"at", now.wipeAt}});
    }
    if (!seen || seen->samplesPerSide != now.samplesPerSide) {
        log.write("samples", {{"side", static_cast<long long>(now.samplesPerSide)}});
    }
    if (!seen || changedByHand(seen->animation, now.animation)) {
        log.write("time", {{"seconds", now.animation.seconds},
                           {"playing", now.animation.playing},
                           {"speed", now.animation.speed}});
    }
    if (!seen || seen->panel != now.panel || seen->help != now.help || seen->pixel != now.pixel) {
        log.write("shown", {{"panel", now.panel}, {"help", now.help}, {"pixel", now.pixel}});
    }
    if (!seen || seen->focus != now.focus) {
        log.write("focus", {{"panel", now.focus}});
    }
    seen = now;
}

}  // namespace raytorus::viewer
