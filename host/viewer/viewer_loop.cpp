// SPDX-License-Identifier: MIT
#include "viewer/viewer_loop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "scene/scene_json.hpp"
#include "trace/device_words.hpp"
#include "viewer/capture.hpp"
#include "viewer/commands.hpp"
#include "viewer/picking.hpp"

namespace raytorus::viewer {
namespace {

constexpr double idleSeconds = 0.05;    // between looks at files and at the background's work
constexpr double retrySeconds = 0.005;  // after a frame that the window did not take
constexpr double messageSeconds = 4.0;
constexpr double largestTimeStep =
    0.1;  // of an animation: after a pause of the program it goes on from there

}  // namespace

ViewerLoop::ViewerLoop(const ViewerOptions& viewerOptions, Window& shownWindow, gpu::Context& gpuContext,
                       State firstState, std::vector<MethodEntry> methodList)
    : options(viewerOptions),
      window(shownWindow),
      context(gpuContext),
      methods(std::move(methodList)),
      state(std::move(firstState)),
      swapchain(context, window),
      gui(context, window, swapchain),
      pictures(context, nonZero(window.framebufferSize())),
      viewPass(context),
      log(options.events),
      inspection(context, viewPass, log),
      sceneWatch(watchFile(state.sceneFile)) {
    inspection.openGolden(options.golden, state.sceneFile);
    if (!options.edit.empty()) {
        edited = std::make_unique<EditedShaders>(options.edit);
    }
}

VkExtent2D ViewerLoop::nonZero(VkExtent2D extent) {
    return {std::max(1U, extent.width), std::max(1U, extent.height)};
}

compile::FileWatch ViewerLoop::watchFile(const std::string& file) {
    compile::FileWatch watch;
    const std::filesystem::path path = std::filesystem::absolute(file);
    watch.watch({{path, compile::fingerprint(compile::readSourceFile(path))}});
    return watch;
}

void ViewerLoop::run() {
    log.write("open", {{"scene", state.sceneFile}, {"device", context.info().name}});
    while (!window.closed() && !state.closing) {
        round();
    }
    log.write("closed");
}

bool ViewerLoop::isScript() const {
    return options.frames > 0 || !options.sequence.empty() || !options.screenshot.empty() ||
           !options.windowScreenshot.empty();
}

void ViewerLoop::say(const std::string& text) {
    state.message = {text, clock() + messageSeconds};
    dirtyFrames = uiFrames;
    log.write("message", {{"text", text}});
}

void ViewerLoop::round() {
    const bool moves = animated() && state.animation.playing;
    const bool busy = pictures.drawing() || dirtyFrames > 0 || viewStale || moves || isScript();
    const double wait = unshown ? retrySeconds : 0.0;
    const std::vector<InputEvent> events = window.poll(busy && !hidden ? wait : idleSeconds);
    roundBegin = clock();
    roundDrawing = 0.0;
    takeTime();
    for (const InputEvent& event : events) {
        gui.take(event);
        take(event);
    }
    if (window.takeRefresh() || !events.empty() || gui.wantsFrame()) {
        dirtyFrames = uiFrames;
    }
    followFiles();
    serve();
    changes.note(state, methods, gui.takesKeys(), log);
    const VkExtent2D size = window.framebufferSize();
    noteSize(size);
    hidden = size.width == 0 || size.height == 0;
    if (hidden) {  // minimised: nothing can be shown
        return;
    }
    updatePictures(size);
    attempt([&] { viewStale = inspection.update(state, pictures, shadersOf(state.left)) || viewStale; });
    if (viewStale && !pictures.drawing() && pictures.shown()) {
        drawView();
    }
    serveAtRest();
    if (dirtyFrames > 0) {
        showFrame();
    }
    finishScript();
}

void ViewerLoop::takeTime() {
    const double now = clock();
    const double step = std::min(now - lastRound, largestTimeStep);
    lastRound = now;
    if (animated() && state.animation.playing && !isScript()) {
        state.animation.seconds += state.animation.speed * step;
    }
    if (state.message.until > 0.0 && now > state.message.until) {
        state.message = {};
        dirtyFrames = uiFrames;
    }
}

void ViewerLoop::take(const InputEvent& event) {
    if (event.type == InputEvent::Type::Key) {
        if (event.pressed && !gui.takesKeys() && runCommand(state, event.code, event.modifiers)) {
            log.write("key", {{"code", static_cast<long long>(event.code)}});
        }
        return;
    }
    if (event.type == InputEvent::Type::Drop) {
        attempt([&] { open(event.text); });
        return;
    }
    const VkExtent2D size = window.framebufferSize();
    pointer.handle(event, state, size, picturePlace(size), gui.takesPointer());
}

void ViewerLoop::open(const std::string& file) {
    sceneWatch = watchFile(file);  // first, so that a broken scene is read again when it is mended
    const scene::Scene scene = scene::readScene(file);
    // Whoever edits the file keeps the view of it, unless it is the camera that was edited.
    const bool sameCamera = file == state.sceneFile && scene.camera == state.fileScene.camera;
    const scene::Camera camera = sameCamera ? state.scene.camera : scene.camera;
    state.sceneFile = file;
    state.fileScene = scene;
    state.scene = scene;
    state.scene.camera = camera;
    state.selectedTorus = 0;
    state.pick.reset();
    inspection.openGolden(options.golden, file);
    dirtyFrames = uiFrames;
    log.write("scene", {{"file", file}});
}

void ViewerLoop::followFiles() {
    if (!sceneWatch.poll().empty()) {
        attempt([&] { open(state.sceneFile); });
    }
    if (edited && edited->poll()) {
        state.shaderError = edited->error();
        dirtyFrames = uiFrames;
        if (edited->error().empty()) {
            MethodEntry& entry = methods.back();
            entry.shaders = edited->shaders();
            entry.steps = edited->steps();
            ++entry.version;
            log.write("shaders", {{"version", static_cast<long long>(entry.version)}});
        } else {
            log.write("shader-error", {{"text", edited->error()}});
        }
    }
}

void ViewerLoop::serve() {
    if (!state.clipboardRequest.empty()) {
        const std::string text = std::exchange(state.clipboardRequest, {});
        window.setClipboard(text);
        log.write("copied", {{"text", text}});
        say("copied: " + text);
    }
    if ((state.pickRequest || !state.screenshotRequests.empty()) && animated() && !isScript()) {
        state.animation.playing = false;  // what moves is never complete
    }
    if (std::exchange(state.minimiseRequest, false)) {
        window.minimise();
        log.write("minimised");
    }
    if (std::exchange(state.fullScreenRequest, false)) {
        window.toggleFullScreen();
        log.write("fullscreen");
    }
    if (std::exchange(state.reloadRequest, false)) {
        attempt([&] { open(state.sceneFile); });
        if (edited) {
            edited->again();
        }
    }
    if (std::exchange(state.saveRequest, false)) {
        attempt([&] { saveScene(); });
    }
    state.selectedTorus = std::min(state.selectedTorus, state.scene.tori.size() - 1);
}

// What keys have asked for that takes the picture as it is now: in the round that has seen all that they
// changed.
void ViewerLoop::serveAtRest() {
    if (!pictures.settled()) {
        return;
    }
    if (!viewStale && inspection.complete(state)) {
        for (const std::string& extension : std::exchange(state.screenshotRequests, {})) {
            attempt([&] { saveScreenshot(freeName(".", "screenshot", extension)); });
        }
    }
    if (state.pickRequest) {
        const auto pixel = *std::exchange(state.pickRequest, std::nullopt);
        attempt([&] { pick(pixel); });
    }
}

void ViewerLoop::noteSize(VkExtent2D size) {
    if (size.width != lastSize.width || size.height != lastSize.height) {
        lastSize = size;
        dirtyFrames = uiFrames;
        log.write("size", {{"width", static_cast<long long>(size.width)},
                           {"height", static_cast<long long>(size.height)}});
    }
}

void ViewerLoop::pick(std::pair<int, int> pixel) {
    const VkExtent2D extent = pictures.extent();
    const auto [x, y] = pixel;
    if (x >= static_cast<int>(extent.width) || y >= static_cast<int>(extent.height)) {
        throw Error(ExitCode::Usage, fmt::format("pixel ({}, {}) is outside the picture of {} x {}", x, y,
                                                 extent.width, extent.height));
    }
    state.pick = pickPixel(context, pictures.scene(), extent, x, y, methods[0].shaders,
                           trace::deviceWords(options.device.context, ""));
    log.write("picked", {{"x", static_cast<long long>(x)},
                         {"y", static_cast<long long>(y)},
                         {"command", state.pick->command},
                         {"text", state.pick->text}});
    dirtyFrames = uiFrames;
}

void ViewerLoop::saveScene() {
    const std::filesystem::path path = freeName(".", "scene", ".json");
    scene::Scene scene = state.scene;
    scene.imageWidth = static_cast<int>(pictures.size().width);
    scene.imageHeight = static_cast<int>(pictures.size().height);
    const std::string text = scene::writeScene(scene);
    writeFile(path, std::as_bytes(std::span(text)));
    log.write("saved", {{"file", path.string()}});
    say(state.animation.seconds == 0.0 || !animated()
            ? fmt::format("saved {}", path.string())
            : fmt::format("saved {}; it is seen at {} s: raytorus render --time", path.string(),
                          state.animation.seconds));
}

void ViewerLoop::saveScreenshot(const std::filesystem::path& path) {
    writePicture(path, state.view, pictures, viewPass);
    log.write("screenshot", {{"file", path.string()}});
    say("saved " + path.string());
}

bool ViewerLoop::scriptDone() const {
    return isScript() && framesShown + 1 >= std::max(options.frames, uiFrames + 1) && pictures.settled() &&
           !viewStale && inspection.complete(state) && !state.pickRequest && !(edited && !edited->any());
}

void ViewerLoop::finishScript() {
    if (!isScript()) {
        return;
    }
    dirtyFrames = std::max(dirtyFrames, 1);  // each round shows a frame
    if (edited && !edited->error().empty()) {
        throw Error(ExitCode::Shader, edited->error());
    }
    const bool written = options.windowScreenshot.empty() || windowWritten;
    if (!scriptDone() || !written || framesShown < options.frames) {
        return;
    }
    if (sequenceWritten < options.sequence.size()) {
        finishSequence();
        return;
    }
    if (!options.screenshot.empty()) {
        saveScreenshot(options.screenshot);
    }
    state.closing = true;
}

// Writes the picture that is complete and goes on to the next moment.
void ViewerLoop::finishSequence() {
    const options::Frame& frame = options.sequence[sequenceWritten];
    if (state.animation.seconds == frame.seconds) {
        saveScreenshot(frame.output);
        ++sequenceWritten;
    }
    if (sequenceWritten < options.sequence.size()) {
        state.animation.seconds = options.sequence[sequenceWritten].seconds;
        viewStale = true;
    }
}

}  // namespace raytorus::viewer
