// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/scene_animation.hpp"
#include "viewer/capture.hpp"
#include "viewer/navigation.hpp"
#include "viewer/overlays.hpp"
#include "viewer/panel.hpp"
#include "viewer/viewer_loop.hpp"

namespace raytorus::viewer {
namespace {

constexpr double drawSeconds = 0.030;  // of a round, while a picture takes longer than that

}  // namespace

const trace::ShaderSource& ViewerLoop::shadersOf(const Side& side) const {
    const MethodEntry& method = methods[side.method];
    return state.view == View::Steps ? method.steps : method.shaders;
}

ShaderVersion ViewerLoop::versionOf(const Side& side) const {
    return {side.method, methods[side.method].version, state.view == View::Steps};
}

void ViewerLoop::updatePictures(VkExtent2D size) {
    Wish wish;
    wish.scene = scene::sceneAt(state.scene, state.animation.seconds);
    wish.shaders = {shadersOf(state.left), shadersOf(state.right)};
    wish.shaderVersions = {versionOf(state.left), versionOf(state.right)};
    wish.routes = {state.left.route, state.right.route};
    wish.right = state.wipe;
    wish.aovs = needsAovs(state.view);
    wish.samplesPerSide = state.samplesPerSide;
    wish.still = isScript();
    try {
        pictures.resize(size);
        pictures.update(wish, clock());
        const double drawingFrom = clock();
        const bool drawn = pictures.draw(drawSeconds);
        roundDrawing = clock() - drawingFrom;
        if (drawn) {
            viewStale = true;
            inspection.forget();
            notePicture();
        }
    } catch (const Error& error) {
        // What glslang takes, a driver may still refuse: then the library draws in place of what is
        // edited.
        if (error.exitCode != ExitCode::Shader || !edited) {
            throw;
        }
        state.shaderError = error.what();
        methods.back().shaders = methods.front().shaders;
        methods.back().steps = methods.front().steps;
        ++methods.back().version;
        log.write("shader-error", {{"text", state.shaderError}});
    }
    const auto looks = std::tuple(state.view, state.wipeAt, state.mostSteps);
    if (looks != lastLooks) {
        if (state.view != std::get<0>(lastLooks)) {
            log.write("view", {{"name", std::string(infoOf(state.view).name)}});
        }
        lastLooks = looks;
        viewStale = true;
    }
}

void ViewerLoop::notePicture() {
    Statistics& statistics = state.statistics;
    statistics.extent = pictures.extent();
    statistics.samples = pictures.samples();
    statistics.drawSeconds = pictures.times().seconds;
    statistics.deviceSeconds = pictures.times().deviceSeconds;
    statistics.compiled = pictures.times().compiled;
    if (pictures.settled()) {
        log.write("settled", {{"width", static_cast<long long>(statistics.extent.width)},
                              {"height", static_cast<long long>(statistics.extent.height)},
                              {"samples", static_cast<long long>(statistics.samples)},
                              {"method", methods[state.left.method].name},
                              {"ms", 1e3 * statistics.drawSeconds}});
    }
}

view_io::ViewPush ViewerLoop::viewPush() const {
    const VkExtent2D extent = state.view == View::Golden ? inspection.goldenSize() : pictures.extent();
    view_io::ViewPush push{};
    push.width = extent.width;
    push.height = extent.height;
    push.view = static_cast<std::uint32_t>(state.view);
    push.wipe = extent.width;
    if (pictures.hasRight() && !needsAnalysis(state.view)) {
        push.wipe = static_cast<std::uint32_t>(std::lround(state.wipeAt * extent.width));
    }
    push.linear = swapchain.encodesSrgb() ? 1 : 0;
    const scene::Sphere bounds = scene::enclosingSphere(pictures.scene().tori);
    const double distance = glm::length(pictures.scene().camera.position - bounds.center);
    push.nearest = static_cast<float>(std::max(0.0, distance - bounds.radius));
    push.farthest = static_cast<float>(distance + bounds.radius);
    push.mostSteps = static_cast<float>(state.mostSteps);
    return push;
}

void ViewerLoop::drawView() {
    viewPass.draw(pictures.side(0), pictures.hasRight() ? &pictures.side(1) : nullptr, viewPush());
    viewStale = false;
    dirtyFrames = std::max(dirtyFrames, 1);
}

bool ViewerLoop::fills() const {
    return state.view != View::Golden && pictures.shown() == Quality::Moving;
}

VkRect2D ViewerLoop::picturePlace(VkExtent2D size) const {
    const VkExtent2D extent = viewPass.extent();
    return extent.width == 0 || fills() ? VkRect2D{{0, 0}, size} : placeOf(extent, size);
}

void ViewerLoop::showFrame() {
    const VkExtent2D size = window.framebufferSize();
    gui.begin();
    if (state.panel) {
        drawPanel(state, {&methods, fmt::format("{}, {}", context.info().name, context.info().driverInfo),
                          animated()});
    }
    drawOverlays(state, methods, picturePlace(size), clock());
    gui.end();
    const bool scripted = scriptDone() && !options.windowScreenshot.empty();
    const bool wanted = scripted || state.windowShotRequest;
    std::optional<FrameCopy> copy;
    const FrameResult result = swapchain.show([&](VkCommandBuffer commands, const FrameTarget& target) {
        if (wanted && swapchain.canRead()) {
            copy.emplace(context, target.extent);
        }
        const VkExtent2D extent = viewPass.extent();
        recordFrame(commands, target, {extent.width > 0 ? &viewPass.shown() : nullptr, extent, fills()}, gui,
                    swapchain.renderPass(), copy ? &*copy : nullptr);
    });
    unshown = result == FrameResult::Later;
    if (unshown) {
        return;
    }
    --dirtyFrames;
    ++framesShown;
    noteFrame();
    if (wanted) {
        state.windowShotRequest = false;
        windowWritten = windowWritten || scripted;
        attempt([&] {
            saveWindow(
                scripted ? std::filesystem::path(options.windowScreenshot) : freeName(".", "window", ".png"),
                copy ? &*copy : nullptr);
        });
    }
}

void ViewerLoop::saveWindow(const std::filesystem::path& path, const FrameCopy* copy) {
    if (copy == nullptr) {
        throw Error(ExitCode::NoDevice, "this window's contents cannot be read back");
    }
    writeDisplayed(path, copy->picture(swapchain.format()));
    log.write("window-screenshot", {{"file", path.string()}});
}

void ViewerLoop::noteFrame() {
    const double now = clock();
    const double interval = std::max(now - std::exchange(lastFrame, now), 1e-6);
    const bool moving = pictures.shown() == Quality::Moving;
    if (moving) {
        pictures.learnShowing(now - roundBegin - roundDrawing);
    }
    if (movedFrames > 0 && (!moving || movedSeconds >= 1.0)) {
        const VkExtent2D extent = pictures.extent();
        log.write("rate", {{"fps", movedFrames / movedSeconds},
                           {"frames", static_cast<long long>(movedFrames)},
                           {"width", static_cast<long long>(extent.width)},
                           {"height", static_cast<long long>(extent.height)}});
        movedFrames = 0;
        movedSeconds = 0.0;
    }
    if (interval < 0.5) {  // what lies between frames at rest says nothing about speed
        double& shown = state.statistics.framesPerSecond;
        shown += (shown == 0.0 ? 1.0 : 0.1) * (1.0 / interval - shown);
        movedSeconds += moving ? interval : 0.0;
        movedFrames += moving ? 1 : 0;
    }
}

}  // namespace raytorus::viewer
