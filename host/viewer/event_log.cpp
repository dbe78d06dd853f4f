// SPDX-License-Identifier: MIT
#include "viewer/event_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/console.hpp"
#include "core/json_text.hpp"

namespace raytorus::viewer {
namespace {

constexpr double tellingSeconds = 1.0;  // between two events about a rate
constexpr double restSeconds = 0.5;     // what lies between frames at rest says nothing about speed
constexpr double leastInterval = 1e-6;  // seconds, so that a rate is finite
constexpr double smoothing = 0.1;       // part of a frame in the rate that the panel shows

std::vector<double> numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

bool changedByHand(const Animation& before, const Animation& now) {
    const bool jumped = now.playing ? now.seconds < before.seconds : now.seconds != before.seconds;
    return jumped || now.playing != before.playing || now.speed != before.speed;
}

}  // namespace

void EventLog::write(std::string_view name, std::initializer_list<Field> fields) const {
    if (!on) {
        return;
    }
    nlohmann::ordered_json line;
    line["event"] = name;
    for (const auto& [key, value] : fields) {
        std::visit([&line, name = std::string(key)](const auto& item) { line[name] = item; }, value);
    }
    print("{}\n", dumpJson(line, -1));
    flushOutput();
}

void ChangeLog::note(const State& state, bool panelTakesKeys, const EventLog& log) {
    const Seen now{state.scene.camera,   state.left,      state.right, state.wipe, state.wipeAt,
                   state.samplesPerSide, state.animation, state.panel, state.help, state.pick.has_value(),
                   panelTakesKeys};
    if (!seen || seen->camera != now.camera) {
        log.write("camera", {{"position", numbers(now.camera.position)},
                             {"target", numbers(now.camera.target)},
                             {"up", numbers(now.camera.up)}});
    }
    if (!seen || seen->left != now.left || seen->right != now.right) {
        log.write("method", {{"left", state.methods[now.left.method].name},
                             {"right", state.methods[now.right.method].name},
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

bool ChangeLog::noteSize(VkExtent2D size, const EventLog& log) {
    if (size.width == seenSize.width && size.height == seenSize.height) {
        return false;
    }
    seenSize = size;
    log.write("size", {{"width", static_cast<long long>(size.width)},
                       {"height", static_cast<long long>(size.height)}});
    return true;
}

void RateLog::noteFrame(double now, bool moving, PictureStatistics& statistics, const EventLog& log) {
    const double interval = std::max(now - std::exchange(lastFrame, now), leastInterval);
    if (movedFrames > 0 && (!moving || movedSeconds >= tellingSeconds)) {
        log.write("rate", {{"fps", movedFrames / movedSeconds},
                           {"frames", static_cast<long long>(movedFrames)},
                           {"width", static_cast<long long>(statistics.extent.width)},
                           {"height", static_cast<long long>(statistics.extent.height)}});
        movedFrames = 0;
        movedSeconds = 0.0;
    }
    if (interval >= restSeconds) {
        return;
    }
    double& shown = statistics.framesPerSecond;
    shown += (shown == 0.0 ? 1.0 : smoothing) * (1.0 / interval - shown);
    if (moving) {
        movedSeconds += interval;
        ++movedFrames;
    }
}

}  // namespace raytorus::viewer
