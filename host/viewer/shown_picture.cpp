// SPDX-License-Identifier: MIT
#include "viewer/shown_picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "image/image_io.hpp"
#include "scene/scene.hpp"
#include "viewer/capture.hpp"
#include "viewer/navigation.hpp"

namespace raytorus::viewer {
namespace {

constexpr double roundSeconds = 0.030;  // that drawing has of a round, while a picture takes longer than that

const trace::ShaderSource& shadersOf(const State& state, const Side& side) {
    const MethodEntry& method = state.methods[side.method];
    return state.view == PictureView::Steps ? method.steps : method.shaders;
}

ShaderVersion versionOf(const State& state, const Side& side) {
    return {side.method, state.methods[side.method].version, state.view == PictureView::Steps};
}

Wish wishOf(const State& state, bool still) {
    Wish wish;
    wish.scene = scene::sceneAt(state.scene, state.animation.seconds);
    wish.shaders = {shadersOf(state, state.left), shadersOf(state, state.right)};
    wish.shaderVersions = {versionOf(state, state.left), versionOf(state, state.right)};
    wish.routes = {state.left.route, state.right.route};
    wish.right = state.wipe;
    wish.aovs = needsAovs(state.view);
    wish.samplesPerSide = state.samplesPerSide;
    wish.still = still;
    return wish;
}

image::Image colorsOf(const image::Image& picture) {
    image::Image colors(picture.width, picture.height, {"R", "G", "B", "A"});
    const auto channels = static_cast<std::size_t>(picture.channelCount());
    for (std::size_t i = 0; i < colors.pixels.size(); ++i) {
        colors.pixels[i] = picture.pixels[i / 4 * channels + i % 4];
    }
    return colors;
}

}  // namespace

ShownPicture::ShownPicture(gpu::Context& context, const EventLog& eventLog, VkExtent2D window, bool isLinear)
    : log(&eventLog),
      pictures(context, {std::max(1U, window.width), std::max(1U, window.height)}),
      viewPass(context),
      inspection(context, viewPass, eventLog),
      linear(isLinear) {}

void ShownPicture::openGolden(const std::string& file, const std::filesystem::path& scene) {
    inspection.openGolden(file, scene);
}

void ShownPicture::draw(State& state, VkExtent2D window, double now, bool still) {
    using Clock = std::chrono::steady_clock;
    drawingSeconds = 0.0;
    try {
        pictures.resize(window);
        pictures.update(wishOf(state, still), now);
        const Clock::time_point begin = Clock::now();
        const bool drawn = pictures.draw(roundSeconds);
        drawingSeconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (drawn) {
            noteDrawn(state);
        }
    } catch (const Error& error) {
        // What glslang takes, a driver may still refuse: then the library draws in place of what is edited.
        MethodEntry& last = state.methods.back();
        if (error.exitCode != ExitCode::Shader || !last.edited) {
            throw;
        }
        state.shaderError = error.what();
        replaceShaders(last, state.methods.front().shaders, state.methods.front().steps);
        log->write("shader-error", {{"text", state.shaderError}});
    }
    noteLooks(state);
}

void ShownPicture::noteDrawn(State& state) {
    stale = true;
    inspection.forget();
    PictureStatistics& statistics = state.statistics;
    statistics.extent = pictures.extent();
    statistics.samples = pictures.samples();
    statistics.drawSeconds = pictures.times().seconds;
    statistics.deviceSeconds = pictures.times().deviceSeconds;
    statistics.compiled = pictures.times().compiled;
    if (pictures.settled()) {
        log->write("settled", {{"width", static_cast<long long>(statistics.extent.width)},
                               {"height", static_cast<long long>(statistics.extent.height)},
                               {"samples", static_cast<long long>(statistics.samples)},
                               {"method", state.methods[state.left.method].name},
                               {"ms", 1e3 * statistics.drawSeconds}});
    }
}

// What changes the view of a picture, and not the picture.
void ShownPicture::noteLooks(const State& state) {
    const auto looks = std::tuple(state.view, state.wipeAt, state.mostSteps);
    if (looks == lastLooks) {
        return;
    }
    if (state.view != std::get<0>(lastLooks)) {
        log->write("view", {{"name", std::string(infoOf(state.view).name)}});
    }
    lastLooks = looks;
    stale = true;
}

void ShownPicture::inspect(State& state) {
    if (inspection.update(state, pictures, shadersOf(state, state.left))) {
        stale = true;
    }
}

view_io::ViewPush ShownPicture::viewPush(const State& state) const {
    const VkExtent2D extent = state.view == PictureView::Golden ? inspection.goldenSize() : pictures.extent();
    view_io::ViewPush push{};
    push.width = extent.width;
    push.height = extent.height;
    push.view = static_cast<std::uint32_t>(state.view);
    push.wipe = extent.width;
    if (pictures.hasRight() && !needsAnalysis(state.view)) {
        push.wipe = static_cast<std::uint32_t>(std::lround(state.wipeAt * extent.width));
    }
    push.linear = linear ? 1 : 0;
    const scene::Sphere bounds = scene::enclosingSphere(pictures.scene().tori);
    const double distance = glm::length(pictures.scene().camera.position - bounds.center);
    push.nearest = static_cast<float>(std::max(0.0, distance - bounds.radius));
    push.farthest = static_cast<float>(distance + bounds.radius);
    push.mostSteps = static_cast<float>(state.mostSteps);
    return push;
}

bool ShownPicture::color(const State& state) {
    if (!stale || pictures.drawing() || !pictures.shown()) {
        return false;
    }
    viewPass.draw(pictures.side(0), pictures.hasRight() ? &pictures.side(1) : nullptr, viewPush(state));
    stale = false;
    return true;
}

FramePicture ShownPicture::framePicture(const State& state) const {
    const VkExtent2D extent = viewPass.extent();
    const bool fills = state.view != PictureView::Golden && moving();
    return {extent.width > 0 ? &viewPass.shown() : nullptr, extent, fills};
}

VkRect2D ShownPicture::place(const State& state, VkExtent2D window) const {
    const FramePicture picture = framePicture(state);
    return picture.image == nullptr || picture.fills ? VkRect2D{{0, 0}, window}
                                                     : placeOf(picture.extent, window);
}

void ShownPicture::write(const std::filesystem::path& path, PictureView view) {
    if (path.extension() == ".exr") {
        image::writeImage(path, pictures.side(0).readBack(pictures.extent()));
    } else if (view == PictureView::Shaded && !pictures.hasRight()) {
        // From the linear colours themselves, so that it is the PNG that render writes.
        image::writeImage(path, colorsOf(pictures.side(0).readBack(pictures.extent())));
    } else {
        writeDisplayed(path, viewPass.readBack());
    }
}

Pick ShownPicture::takeApart(const TakeApart& pixel, const State& state,
                             const std::string& deviceWords) const {
    return inspection.takeApart(pixel, pictures, state.methods.front().shaders, deviceWords);
}

}  // namespace raytorus::viewer
