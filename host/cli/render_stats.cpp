// SPDX-License-Identifier: MIT
#include "cli/render_stats.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/json_text.hpp"

namespace raytorus::cli {
namespace {

// The steady speed: of the fastest repeat, or of the bands after the first, in which drivers compile. A
// picture of one band that is rendered once has no other.
struct SteadySpeed {
    double nanosecondsPerPixel;
    double raysPerSecond;
    const char* of;
};

SteadySpeed steadySpeed(const RenderStats& stats) {
    const render::PassTimes& first = stats.render.firstPass;
    double seconds = first.firstBand;
    auto pixels = static_cast<double>(first.firstPixels);
    const char* of = "one band, compiling included";
    if (stats.render.fastestRepeat) {
        seconds = stats.render.fastestRepeat->total();
        pixels = static_cast<double>(first.firstPixels + first.otherPixels);
        of = "fastest repeat";
    } else if (first.otherPixels > 0) {
        seconds = first.otherBands;
        pixels = static_cast<double>(first.otherPixels);
        of = "bands after the first";
    }
    return {1e9 * seconds / pixels, pixels * stats.samplesPerPixel / seconds, of};
}

}  // namespace

std::string statsText(const RenderStats& stats) {
    const render::RenderTimes& times = stats.render;
    const SteadySpeed speed = steadySpeed(stats);
    std::string text = fmt::format("{} ({})\n{} route, {}x{}, {} sample(s) a pixel\n", stats.device.name,
                                   stats.device.driverInfo, render::infoOf(stats.route).name, stats.width,
                                   stats.height, stats.samplesPerPixel);
    const auto row = [&text](const char* name, double value, const std::string& note = {}) {
        text += fmt::format("  {:<12}{:9.1f} ms{}\n", name, 1e3 * value, note.empty() ? "" : "   " + note);
    };
    row("scene", stats.read + times.scene);
    row("instance", stats.instance);
    row("pipeline", times.pipeline);
    row("first band", times.firstPass.firstBand,
        fmt::format("{} pixels; drivers compile here", times.firstPass.firstPixels));
    row("render", times.firstPass.otherBands, fmt::format("{} pixels", times.firstPass.otherPixels));
    if (times.fastestRepeat) {
        row("repeat", times.fastestRepeat->total(), "the whole picture, the fastest of the repeats");
    }
    row("read back", times.readBack);
    row("write", stats.write);
    row("total", stats.total);
    text += fmt::format("  {:.2f} ns a pixel, {:.1f} million camera rays a second ({})",
                        speed.nanosecondsPerPixel, 1e-6 * speed.raysPerSecond, speed.of);
    return text;
}

std::string statsJson(const RenderStats& stats) {
    const render::RenderTimes& times = stats.render;
    const SteadySpeed speed = steadySpeed(stats);
    nlohmann::ordered_json json = {
        {"device", stats.device.name},
        {"driver", stats.device.driverInfo},
        {"route", render::infoOf(stats.route).name},
        {"width", stats.width},
        {"height", stats.height},
        {"samplesPerPixel", stats.samplesPerPixel},
        {"seconds",
         {{"scene", stats.read + times.scene},
          {"instance", stats.instance},
          {"pipeline", times.pipeline},
          {"firstBand", times.firstPass.firstBand},
          {"render", times.firstPass.otherBands},
          {"renderOnDevice", times.firstPass.deviceOtherBands},
          {"readBack", times.readBack},
          {"write", stats.write},
          {"total", stats.total}}},
        {"pixels", {{"firstBand", times.firstPass.firstPixels}, {"render", times.firstPass.otherPixels}}},
        {"nanosecondsPerPixel", speed.nanosecondsPerPixel},
        {"cameraRaysPerSecond", speed.raysPerSecond},
        {"speedOf", speed.of},
    };
    if (times.fastestRepeat) {
        json["seconds"]["fastestRepeat"] = times.fastestRepeat->total();
    }
    return dumpJson(json);
}

}  // namespace raytorus::cli
