// SPDX-License-Identifier: MIT
#include "cli/render_stats.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace raytorus::cli {
namespace {

const char* routeName(render::Route route) {
    return route == render::Route::Fragment ? "fragment" : "compute";
}

// The steady speed: of the bands after the first, in which drivers compile. A picture of one band has no
// other.
double steadySeconds(const render::RenderTimes& times) {
    return times.otherPixels > 0 ? times.otherBands : times.firstBand;
}

std::int64_t steadyPixels(const render::RenderTimes& times) {
    return times.otherPixels > 0 ? times.otherPixels : times.firstPixels;
}

}  // namespace

std::string statsText(const RenderStats& stats) {
    const render::RenderTimes& times = stats.render;
    const double seconds = steadySeconds(times);
    const auto pixels = static_cast<double>(steadyPixels(times));
    std::string text = fmt::format("{} ({})\n{} route, {}x{}, {} sample(s) a pixel\n", stats.device.name,
                                   stats.device.driverInfo, routeName(stats.route), stats.width, stats.height,
                                   stats.samplesPerPixel);
    const auto row = [&text](const char* name, double value, const std::string& note = {}) {
        text += fmt::format("  {:<12}{:9.1f} ms{}\n", name, 1e3 * value, note.empty() ? "" : "   " + note);
    };
    row("scene", stats.read + times.scene);
    row("instance", stats.instance);
    row("pipeline", times.pipeline);
    row("first band", times.firstBand, fmt::format("{} pixels; drivers compile here", times.firstPixels));
    row("render", times.otherBands, fmt::format("{} pixels", times.otherPixels));
    row("read back", times.readBack);
    row("write", stats.write);
    row("total", stats.total);
    text += fmt::format("  {:.2f} ns a pixel, {:.1f} million camera rays a second{}", 1e9 * seconds / pixels,
                        1e-6 * pixels * stats.samplesPerPixel / seconds,
                        times.otherPixels > 0 ? "" : " (one band: compiling included)");
    return text;
}

std::string statsJson(const RenderStats& stats) {
    const render::RenderTimes& times = stats.render;
    const double seconds = steadySeconds(times);
    const auto pixels = static_cast<double>(steadyPixels(times));
    nlohmann::ordered_json json = {
        {"device", stats.device.name},
        {"driver", stats.device.driverInfo},
        {"route", routeName(stats.route)},
        {"width", stats.width},
        {"height", stats.height},
        {"samplesPerPixel", stats.samplesPerPixel},
        {"seconds",
         {{"scene", stats.read + times.scene},
          {"instance", stats.instance},
          {"pipeline", times.pipeline},
          {"firstBand", times.firstBand},
          {"render", times.otherBands},
          {"readBack", times.readBack},
          {"write", stats.write},
          {"total", stats.total}}},
        {"pixels", {{"firstBand", times.firstPixels}, {"render", times.otherPixels}}},
        {"nanosecondsPerPixel", 1e9 * seconds / pixels},
        {"cameraRaysPerSecond", pixels * stats.samplesPerPixel / seconds},
    };
    json["seconds"]["renderOnDevice"] =
        times.deviceOtherBands ? nlohmann::ordered_json(*times.deviceOtherBands) : nlohmann::ordered_json();
    return json.dump(2);
}

}  // namespace raytorus::cli
