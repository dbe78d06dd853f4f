// SPDX-License-Identifier: MIT
#include "viewer/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/file.hpp"
#include "image/image_io.hpp"
#include "render/scene_json.hpp"
#include "viewer/analysis.hpp"
#include "viewer/capture.hpp"
#include "viewer/commands.hpp"
#include "viewer/event_log.hpp"
#include "viewer/frame.hpp"
#include "viewer/golden_view.hpp"
#include "viewer/gui.hpp"
#include "viewer/method_list.hpp"
#include "viewer/navigation.hpp"
#include "viewer/overlays.hpp"
#include "viewer/panel.hpp"
#include "viewer/picking.hpp"
#include "viewer/pictures.hpp"
#include "viewer/pointer.hpp"
#include "viewer/swapchain.hpp"
#include "viewer/view_pass.hpp"

namespace raytorus::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double drawSeconds = 0.030;  // of a loop's round, while a picture takes longer than that
constexpr double idleSeconds = 0.05;   // between looks at files and at the analysis
constexpr int uiFrames = 3;            // until ImGui has settled after an input
constexpr double messageSeconds = 4.0;
constexpr double largestTimeStep =
    0.1;  // of an animation: after a pause of the program it goes on from there

State firstState(const ViewerOptions& options, const std::vector<MethodEntry>& methods) {
    State state;
    state.sceneFile = options.scene;
    state.fileScene = render::readScene(options.scene);
    state.scene = state.fileScene;
    state.view = options.view;
    state.left = {indexOf(methods, options.method), options.route};
    state.right = {options.wipeMethod.empty() ? std::size_t{1} : indexOf(methods, options.wipeMethod),
                   options.route};
    state.wipe = !options.wipeMethod.empty();
    state.wipeAt = options.wipeAt;
    state.samplesPerSide = options.samplesPerSide;
    state.animation.seconds = options.time;
    state.animation.playing = !options.paused;
    state.panel = options.panel;
    state.help = options.help;
    state.pickRequest = options.pick;
    return state;
}

class Viewer {
public:
    Viewer(const ViewerOptions& viewerOptions, Window& shownWindow, gpu::Context& gpuContext,
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
          log(options.events) {
        openGolden();
    }

    void run() {
        log.write("open", {{"scene", state.sceneFile}, {"device", context.info().name}});
        while (!window.closed() && !state.closing) {
            round();
        }
        log.write("closed");
    }

private:
    static VkExtent2D nonZero(VkExtent2D extent) {
        return {std::max(1U, extent.width), std::max(1U, extent.height)};
    }

    [[nodiscard]] double clock() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }

    void say(const std::string& text) {
        state.message = {text, clock() + messageSeconds};
        dirtyFrames = uiFrames;
        log.write("message", {{"text", text}});
    }

    // A fault of what was asked for is told, and the viewer goes on; only a lost device and its like end it.
    template <typename Function>
    void attempt(const Function& function) {
        try {
            function();
        } catch (const Error& error) {
            if (error.exitCode == ExitCode::DeviceLost || error.exitCode == ExitCode::ValidationMessage ||
                isScript()) {
                throw;
            }
            say(error.what());
        }
    }

    [[nodiscard]] bool isScript() const {
        return options.frames > 0 || !options.screenshot.empty() || !options.windowScreenshot.empty();
    }

    void openGolden() {
        golden.reset();
        if (!options.golden.empty()) {
            golden = readGolden(options.golden);
        } else {
            golden = findGolden(state.sceneFile);
        }
        goldenStale = true;
    }

    void round() {
        const bool busy = pictures.drawing() || dirtyFrames > 0 || viewStale || isScript() || animated();
        const std::vector<InputEvent> events = window.poll(busy ? 0.0 : idleSeconds);
        takeTime();
        for (const InputEvent& event : events) {
            take(event);
        }
        if (window.takeRefresh() || !events.empty()) {
            dirtyFrames = uiFrames;
        }
        serve();
        const VkExtent2D size = window.framebufferSize();
        if (size.width == 0 || size.height == 0) {  // minimised: nothing can be shown
            noteSize(size);
            window.poll(idleSeconds);
            return;
        }
        noteSize(size);
        attempt([&] { updatePictures(size); });
        updateAnalysis();
        if (viewStale && !pictures.drawing() && pictures.shown()) {
            drawView();
        }
        if (dirtyFrames > 0) {
            showFrame();
        }
        finishScript();
    }

    [[nodiscard]] bool animated() const { return false; }

    void takeTime() {
        const double now = clock();
        const double step = std::min(now - lastRound, largestTimeStep);
        lastRound = now;
        if (animated() && state.animation.playing) {
            state.animation.seconds += state.animation.speed * step;
        }
        if (state.message.until > 0.0 && now > state.message.until) {
            state.message = {};
            dirtyFrames = uiFrames;
        }
    }

    void take(const InputEvent& event) {
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

    void open(const std::string& file) {
        const render::Scene scene = render::readScene(file);
        state.sceneFile = file;
        state.fileScene = scene;
        state.scene = scene;
        state.selectedTorus = 0;
        state.pick.reset();
        openGolden();
        log.write("scene", {{"file", file}});
    }

    // What keys and panels have asked for.
    void serve() {
        if (!state.clipboardRequest.empty()) {
            window.setClipboard(state.clipboardRequest);
            log.write("copied", {{"text", state.clipboardRequest}});
            say("copied: " + state.clipboardRequest);
            state.clipboardRequest.clear();
        }
        if (std::exchange(state.fullScreenRequest, false)) {
            window.toggleFullScreen();
            log.write("fullscreen");
        }
        if (std::exchange(state.reloadRequest, false)) {
            attempt([&] { open(state.sceneFile); });
        }
        if (std::exchange(state.saveRequest, false)) {
            attempt([&] { saveScene(); });
        }
        if (!state.screenshotRequest.empty() && pictures.settled() && analysisComplete()) {
            const std::string extension = std::exchange(state.screenshotRequest, {});
            attempt([&] { saveScreenshot(freeName(".", "screenshot", extension)); });
        }
        if (state.pickRequest && pictures.settled()) {
            attempt([&] { pick(*state.pickRequest); });
            state.pickRequest.reset();
        }
        state.selectedTorus = std::min(state.selectedTorus, state.scene.tori.size() - 1);
    }

    void noteSize(VkExtent2D size) {
        if (size.width != lastSize.width || size.height != lastSize.height) {
            lastSize = size;
            dirtyFrames = uiFrames;
            log.write("size", {{"width", static_cast<long long>(size.width)},
                               {"height", static_cast<long long>(size.height)}});
        }
    }

    [[nodiscard]] const render::ShaderSource& shadersOf(const Side& side) const {
        const MethodEntry& method = methods[side.method];
        return state.view == View::Steps ? method.steps : method.shaders;
    }

    [[nodiscard]] int versionOf(const Side& side) const {
        return 2 * methods[side.method].version + (state.view == View::Steps ? 1 : 0);
    }

    [[nodiscard]] render::Scene shownScene() const { return state.scene; }

    void updatePictures(VkExtent2D size) {
        pictures.resize(size);
        Wish wish;
        wish.scene = shownScene();
        wish.shaders = {shadersOf(state.left), shadersOf(state.right)};
        wish.shaderVersions = {versionOf(state.left), versionOf(state.right)};
        wish.routes = {state.left.route, state.right.route};
        wish.right = state.wipe;
        wish.aovs = needsAovs(state.view);
        wish.samplesPerSide = state.samplesPerSide;
        wish.still = isScript();
        pictures.update(wish, clock());
        if (pictures.draw(drawSeconds)) {
            viewStale = true;
            analysisStale = true;
            goldenStale = true;
            notePicture();
        }
        if (state.view != lastView || state.wipeAt != lastWipe || state.mostSteps != lastSteps) {
            if (state.view != lastView) {
                log.write("view", {{"name", std::string(infoOf(state.view).name)}});
            }
            viewStale = true;
            lastView = state.view;
            lastWipe = state.wipeAt;
            lastSteps = state.mostSteps;
        }
    }

    void notePicture() {
        Statistics& statistics = state.statistics;
        statistics.extent = pictures.extent();
        statistics.samples = pictures.samples();
        statistics.drawSeconds = pictures.times().seconds;
        statistics.deviceSeconds = pictures.times().deviceSeconds;
        if (pictures.settled()) {
            log.write("settled", {{"width", static_cast<long long>(statistics.extent.width)},
                                  {"height", static_cast<long long>(statistics.extent.height)},
                                  {"samples", static_cast<long long>(statistics.samples)},
                                  {"method", methods[state.left.method].name},
                                  {"ms", 1e3 * statistics.drawSeconds}});
        }
    }

    [[nodiscard]] bool analysed() const {
        return state.view == View::Surface || state.view == View::Reference;
    }

    // Surface and Reference are worked out for pictures at rest; Golden at once, since it is small.
    void updateAnalysis() {
        if (!analysed()) {
            analysis.stop();
            analysisStale = true;
        }
        if (pictures.drawing() || !pictures.shown()) {
            return;
        }
        if (analysed() && pictures.settled() && analysisStale) {
            analysis.start(pictures.scene(), pictures.side(0).readBack(pictures.extent()));
            analysisStale = false;
            state.statistics.analysed = 0.0;
        }
        AnalysisPixels pixels;
        if (analysed() && !analysisStale && analysis.take(pixels)) {
            viewPass.setAnalysis(pixels);
            viewStale = true;
            const Analysis::Progress progress = analysis.progress();
            state.statistics.analysed = progress.part;
            state.statistics.wrongPixels = progress.wrong;
            state.statistics.largestError = progress.largest;
            if (progress.part == 1.0) {
                log.write("analysed", {{"wrong", progress.wrong}, {"largest", progress.largest}});
            }
        }
        if (state.view == View::Golden && goldenStale) {
            attempt([&] { updateGolden(); });
            goldenStale = false;
        }
    }

    void updateGolden() {
        if (!golden) {
            state.goldenSentence = "this scene has no golden picture (--golden FILE.exr names one)";
            goldenSize = {1, 1};
            viewPass.setAnalysis({1, 1, std::vector<float>(4, 0.0F)});
        } else {
            const GoldenView view =
                compareWithGolden(context, state.scene, *golden, shadersOf(state.left), state.left.route);
            goldenSize = {static_cast<std::uint32_t>(view.pixels.width),
                          static_cast<std::uint32_t>(view.pixels.height)};
            viewPass.setAnalysis(view.pixels);
            state.goldenSentence = fmt::format("{}: {}", golden->name, view.sentence);
        }
        log.write("golden", {{"text", state.goldenSentence}});
        viewStale = true;
    }

    [[nodiscard]] bool analysisComplete() const {
        if (analysed()) {
            return !analysisStale && !viewStale && state.statistics.analysed == 1.0;
        }
        return !viewStale && (state.view != View::Golden || !goldenStale);
    }

    [[nodiscard]] view_io::ViewPush viewPush() const {
        const VkExtent2D extent = state.view == View::Golden ? goldenSize : pictures.extent();
        view_io::ViewPush push{};
        push.width = extent.width;
        push.height = extent.height;
        push.view = static_cast<std::uint32_t>(state.view);
        push.wipe = extent.width;
        if (pictures.hasRight() && !needsAnalysis(state.view)) {
            push.wipe = static_cast<std::uint32_t>(std::lround(state.wipeAt * extent.width));
        }
        push.linear = swapchain.encodesSrgb() ? 1 : 0;
        const Bounds bounds = boundsOf(pictures.scene().tori);
        const double distance = glm::length(pictures.scene().camera.position - bounds.center);
        push.nearest = static_cast<float>(std::max(0.0, distance - bounds.radius));
        push.farthest = static_cast<float>(distance + bounds.radius);
        push.mostSteps = static_cast<float>(state.mostSteps);
        return push;
    }

    void drawView() {
        viewPass.draw(pictures.side(0), pictures.hasRight() ? &pictures.side(1) : nullptr, viewPush());
        viewStale = false;
        dirtyFrames = std::max(dirtyFrames, 1);
    }

    [[nodiscard]] bool fills() const {
        return state.view != View::Golden && pictures.shown() == Quality::Moving;
    }

    [[nodiscard]] VkRect2D picturePlace(VkExtent2D size) const {
        const VkExtent2D extent = viewPass.extent();
        return extent.width == 0 || fills() ? VkRect2D{{0, 0}, size} : placeOf(extent, size);
    }

    void showFrame() {
        gui.begin();
        const VkExtent2D size = window.framebufferSize();
        if (state.panel) {
            drawPanel(state, {&methods, fmt::format("{}, {}", context.info().name, context.info().driverInfo),
                              animated()});
        }
        drawOverlays(state, methods, picturePlace(size), clock());
        gui.end();
        const bool last = scriptDone() && !options.windowScreenshot.empty();
        std::optional<FrameCopy> copy;
        const FrameResult result = swapchain.show([&](VkCommandBuffer commands, const FrameTarget& target) {
            if (last && swapchain.canRead()) {
                copy.emplace(context, target.extent);
            }
            const VkExtent2D extent = viewPass.extent();
            const bool any = extent.width > 0;
            recordFrame(commands, target, {any ? &viewPass.shown() : nullptr, extent, fills()}, gui,
                        swapchain.renderPass(), copy ? &*copy : nullptr);
        });
        if (result == FrameResult::Later) {
            return;
        }
        --dirtyFrames;
        ++framesShown;
        const double now = clock();
        const double interval = std::max(now - lastFrame, 1e-6);
        lastFrame = now;
        // What lies between frames at rest says nothing about speed.
        if (interval < 0.5) {
            const double rate = 1.0 / interval;
            double& shown = state.statistics.framesPerSecond;
            shown = shown == 0.0 ? rate : shown + 0.1 * (rate - shown);
        }
        if (last) {
            if (!copy) {
                throw Error(ExitCode::NoDevice, "this window's contents cannot be read back");
            }
            writeDisplayed(options.windowScreenshot, copy->picture(swapchain.format()));
            log.write("window-screenshot", {{"file", options.windowScreenshot}});
            windowWritten = true;
        }
    }

    void pick(std::pair<int, int> pixel) {
        const VkExtent2D extent = pictures.extent();
        const auto [x, y] = pixel;
        if (x >= static_cast<int>(extent.width) || y >= static_cast<int>(extent.height)) {
            throw Error(ExitCode::Usage, fmt::format("pixel ({}, {}) is outside the picture of {} x {}", x, y,
                                                     extent.width, extent.height));
        }
        state.pick = pickPixel(context, pictures.scene(), extent, x, y, methods[0].shaders);
        log.write("picked", {{"x", static_cast<long long>(x)},
                             {"y", static_cast<long long>(y)},
                             {"command", state.pick->command},
                             {"text", state.pick->text}});
        dirtyFrames = uiFrames;
    }

    void saveScene() {
        const std::filesystem::path path = freeName(".", "scene", ".json");
        render::Scene scene = state.scene;
        scene.imageWidth = static_cast<int>(pictures.size().width);
        scene.imageHeight = static_cast<int>(pictures.size().height);
        const std::string text = render::writeScene(scene);
        writeFile(path, std::as_bytes(std::span(text)));
        log.write("saved", {{"file", path.string()}});
        say("saved " + path.string());
    }

    void saveScreenshot(const std::filesystem::path& path) {
        if (path.extension() == ".exr") {
            image::writeImage(path, pictures.side(0).readBack(pictures.extent()));
        } else if (state.view == View::Shaded && !pictures.hasRight()) {
            // From the linear colours themselves, so that it is the PNG that render writes.
            image::Image picture = pictures.side(0).readBack(pictures.extent());
            image::writeImage(path, colorsOf(picture));
        } else {
            writeDisplayed(path, viewPass.readBack());
        }
        log.write("screenshot", {{"file", path.string()}});
        say("saved " + path.string());
    }

    static image::Image colorsOf(const image::Image& picture) {
        image::Image colors(picture.width, picture.height, {"R", "G", "B", "A"});
        const auto channels = static_cast<std::size_t>(picture.channelCount());
        for (std::size_t i = 0; i < colors.pixels.size(); ++i) {
            colors.pixels[i] = picture.pixels[i / 4 * channels + i % 4];
        }
        return colors;
    }

    // Everything that a script waits for is there.
    [[nodiscard]] bool scriptDone() const {
        return isScript() && framesShown + 1 >= options.frames && framesShown > uiFrames &&
               pictures.settled() && analysisComplete() && !state.pickRequest;
    }

    void finishScript() {
        if (!isScript()) {
            return;
        }
        dirtyFrames = std::max(dirtyFrames, 1);  // each round shows a frame
        if (!scriptDone() || framesShown < options.frames ||
            (!options.windowScreenshot.empty() && !windowWritten)) {
            return;
        }
        if (!options.screenshot.empty()) {
            saveScreenshot(options.screenshot);
        }
        state.closing = true;
    }

    const ViewerOptions& options;
    Window& window;
    gpu::Context& context;
    std::vector<MethodEntry> methods;
    State state;
    Swapchain swapchain;
    Gui gui;
    Pictures pictures;
    ViewPass viewPass;
    EventLog log;
    Pointer pointer;
    Analysis analysis;
    std::optional<Golden> golden;
    VkExtent2D goldenSize{1, 1};

    Clock::time_point begin = Clock::now();
    double lastRound = 0.0;
    double lastFrame = 0.0;
    VkExtent2D lastSize{};
    View lastView = View::Shaded;
    double lastWipe = -1.0;
    int lastSteps = 0;
    bool viewStale = true;
    bool analysisStale = true;
    bool goldenStale = true;
    bool windowWritten = false;
    int dirtyFrames = uiFrames;
    int framesShown = 0;
};

}  // namespace

void runViewer(const ViewerOptions& options) {
    std::vector<MethodEntry> methods = builtInMethods();
    State state = firstState(options, methods);
    const int width = options.width > 0 ? options.width : state.scene.imageWidth;
    const int height = options.height > 0 ? options.height : state.scene.imageHeight;
    Window window(fmt::format("{} - raytorus", std::filesystem::path(options.scene).filename().string()),
                  width, height);
    cli::DeviceOptions device = options.device;
    device.context.instanceExtensions = Window::instanceExtensions();
    device.context.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    cli::withDevice(device, [&](gpu::Context& context) {
        Viewer viewer(options, window, context, std::move(state), std::move(methods));
        viewer.run();
    });
}

}  // namespace raytorus::viewer
