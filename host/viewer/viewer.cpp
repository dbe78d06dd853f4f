// SPDX-License-Identifier: MIT
#include "viewer/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "trace/device_words.hpp"
#include "viewer/capture.hpp"
#include "viewer/commands.hpp"
#include "viewer/event_log.hpp"
#include "viewer/followed_files.hpp"
#include "viewer/frame.hpp"
#include "viewer/keys.hpp"
#include "viewer/panels.hpp"
#include "viewer/pointer.hpp"
#include "viewer/shown_picture.hpp"

namespace raytorus::viewer {
namespace {

constexpr double idleSeconds = 0.05;    // between looks at files and at the background's work
constexpr double retrySeconds = 0.005;  // after a frame that the window did not take
constexpr double messageSeconds = 4.0;
// Seconds of an animation: after a pause of the program it goes on from there.
constexpr double largestTimeStep = 0.1;

bool isEmpty(VkExtent2D size) {
    return size.width == 0 || size.height == 0;
}

// Seconds since the window opened, and when the rounds of its loop began.
class RoundClock {
public:
    [[nodiscard]] double now() const { return std::chrono::duration<double>(Clock::now() - opened).count(); }

    // Returns the seconds since the last round began.
    double beginRound() {
        const double before = std::exchange(roundBegin, now());
        return roundBegin - before;
    }

    [[nodiscard]] double inRound() const { return now() - roundBegin; }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point opened = Clock::now();
    double roundBegin = 0.0;
};

// What there is between the beginning and the end of a frame.
struct FrameInWork {
    bool panelFocus = false;               // the panel is given the keys
    std::optional<image::Image> contents;  // read back
};

// From what happens to what is shown, round by round.
class ViewerLoop {
public:
    // All but the state are kept by reference.
    ViewerLoop(const ViewerOptions& viewerOptions, Window& shownWindow, gpu::Context& gpuContext,
               State firstState);

    // Until the window is closed.
    void run();

private:
    void round();
    [[nodiscard]] double waitingSeconds() const;
    void goOn(double seconds);
    void take(const InputEvent& event);
    void followFiles();
    void showFrame();
    void finishRound();

    [[nodiscard]] bool complete() const;
    void say(const std::string& text);
    void open(const std::string& file);
    void writePicture(const std::filesystem::path& file);
    void writeWindow(const std::filesystem::path& file);

    // Serves what waits for the moment, in order.
    void serve(Moment moment);
    void serve(const Quit&) { window.close(); }
    void serve(const ToggleFullScreen&);
    void serve(const Minimise&);
    void serve(const OpenScene& asked) { open(asked.file); }
    void serve(const ReadFilesAgain&);
    void serve(const SaveScene&);
    void serve(const CopyText& asked);
    void serve(const ShowTime& asked);
    void serve(const WritePicture& asked) { writePicture(asked.file); }
    void serve(const TakeApart& asked);
    void serve(const SavePicture& asked) { writePicture(freeName(".", "screenshot", asked.extension)); }
    void serve(const FocusPanel&) { frame.panelFocus = true; }
    void serve(const SaveWindow&) { writeWindow(freeName(".", "window", ".png")); }

    // A fault of what was asked for is told, and the viewer goes on; only a lost device and its like end it.
    template <typename Function>
    void attempt(const Function& function) {
        try {
            function();
        } catch (const Error& error) {
            const bool fatal =
                error.exitCode == ExitCode::DeviceLost || error.exitCode == ExitCode::OutOfMemory;
            if (fatal || script.drives()) {
                throw;
            }
            say(error.what());
        }
    }

    const ViewerOptions& options;
    Window& window;
    gpu::Context& context;
    State state;
    CommandQueue commands;
    ScriptDriver script;
    EventLog log;
    ChangeLog changes;
    RateLog rate;
    Pointer pointer;
    FollowedFiles files;
    WindowFrames frames;
    ShownPicture picture;
    RoundClock clock;
    FrameInWork frame;
};

ViewerLoop::ViewerLoop(const ViewerOptions& viewerOptions, Window& shownWindow, gpu::Context& gpuContext,
                       State firstState)
    : options(viewerOptions),
      window(shownWindow),
      context(gpuContext),
      state(std::move(firstState)),
      script(options.script),
      log(options.events),
      files(state.sceneFile, options.edit),
      frames(context, window),
      picture(context, log, window.framebufferSize(), frames.encodesSrgb()) {
    picture.openGolden(options.golden, state.sceneFile);
    if (options.pick) {
        commands.push(TakeApart{options.pick->first, options.pick->second});
    }
}

void ViewerLoop::run() {
    log.write("open", {{"scene", state.sceneFile}, {"device", context.info().name}});
    while (!window.closed()) {
        round();
    }
    log.write("closed");
}

double ViewerLoop::waitingSeconds() const {
    const bool moves = isAnimated(state) && state.animation.playing;
    const bool busy = picture.busy() || frames.needed() || moves || script.drives();
    if (!busy || isEmpty(window.framebufferSize())) {
        return idleSeconds;
    }
    return frames.late() ? retrySeconds : 0.0;
}

void ViewerLoop::round() {
    const std::vector<InputEvent> events = window.poll(waitingSeconds());
    goOn(clock.beginRound());
    for (const InputEvent& event : events) {
        frames.panels().take(event);
        take(event);
        serve(Moment::AtOnce);
    }
    if (window.takeRefresh() || !events.empty() || frames.panels().wantsFrame()) {
        frames.need();
    }
    followFiles();
    const bool restWanted = commands.waits(Moment::AtRest) || commands.waits(Moment::Complete);
    if (restWanted && isAnimated(state) && !script.drives()) {
        state.animation.playing = false;  // what moves is never complete
    }
    changes.note(state, frames.panels().takesKeys(), log);
    const VkExtent2D size = window.framebufferSize();
    if (changes.noteSize(size, log)) {
        frames.need();
    }
    if (isEmpty(size)) {  // minimised: nothing can be shown
        return;
    }
    picture.draw(state, size, clock.now(), script.drives());
    attempt([&] { picture.inspect(state); });
    if (picture.color(state)) {
        frames.need(1);
    }
    if (picture.complete(state)) {
        serve(Moment::Complete);
    }
    if (picture.settled()) {
        serve(Moment::AtRest);
    }
    if (frames.needed()) {
        showFrame();
    }
    finishRound();
}

void ViewerLoop::goOn(double seconds) {
    if (isAnimated(state) && state.animation.playing && !script.drives()) {
        state.animation.seconds += state.animation.speed * std::min(seconds, largestTimeStep);
    }
    if (state.message.until > 0.0 && clock.now() > state.message.until) {
        state.message = {};
        frames.need();
    }
}

void ViewerLoop::take(const InputEvent& event) {
    const Gui& panels = frames.panels();
    if (event.type == InputEvent::Type::Key) {
        if (event.pressed && !panels.takesKeys() && pressKey(event.code, event.modifiers, state, commands)) {
            log.write("key", {{"code", static_cast<long long>(event.code)}});
        }
    } else if (event.type == InputEvent::Type::Drop) {
        commands.push(OpenScene{event.text});
    } else {
        const VkExtent2D size = window.framebufferSize();
        pointer.handle(event, {size, picture.place(state, size), panels.takesPointer()}, state, commands);
    }
}

void ViewerLoop::followFiles() {
    if (files.sceneChanged()) {
        attempt([&] { open(state.sceneFile); });
    }
    if (files.takeShaders(state)) {
        frames.need();
        if (state.shaderError.empty()) {
            log.write("shaders", {{"version", static_cast<long long>(state.methods.back().version)}});
        } else {
            log.write("shader-error", {{"text", state.shaderError}});
        }
    }
}

void ViewerLoop::showFrame() {
    const VkExtent2D size = window.framebufferSize();
    const bool scripted = script.wantsWindow(complete());
    const bool read = scripted || commands.waits(Moment::Frame);
    frame = {};
    const auto drawPanels = [&] {
        if (state.panel) {
            serve(Moment::Panel);
            drawPanel(state, commands, fmt::format("{}, {}", context.info().name, context.info().driverInfo),
                      frame.panelFocus);
        }
        drawOverlays(state, commands, picture.place(state, size), clock.now());
    };
    if (!frames.show(picture.framePicture(state), drawPanels, read ? &frame.contents : nullptr)) {
        return;
    }
    script.noteFrame();
    if (picture.moving()) {
        picture.learnRound(clock.inRound());
    }
    rate.noteFrame(clock.now(), picture.moving(), state.statistics, log);
    if (scripted) {
        writeWindow(options.script.windowScreenshot);
        script.noteWindowWritten();
    }
    serve(Moment::Frame);
}

// What panels have asked for, and what a script does next.
void ViewerLoop::finishRound() {
    if (script.drives()) {
        frames.need(1);
        if (!files.shaderError().empty()) {
            throw Error(ExitCode::Shader, files.shaderError());
        }
        script.drive(complete(), state.animation.seconds, commands);
    }
    serve(Moment::AtOnce);
}

// All is there that a script waits for.
bool ViewerLoop::complete() const {
    return picture.complete(state) && !commands.waits(Moment::AtRest) && !files.awaitsShaders();
}

void ViewerLoop::say(const std::string& text) {
    state.message = {text, clock.now() + messageSeconds};
    frames.need();
    log.write("message", {{"text", text}});
}

void ViewerLoop::open(const std::string& file) {
    files.open(file, state);
    picture.openGolden(options.golden, file);
    frames.need();
    log.write("scene", {{"file", file}});
}

void ViewerLoop::writePicture(const std::filesystem::path& file) {
    picture.write(file, state.view);
    log.write("screenshot", {{"file", file.string()}});
    say("saved " + file.string());
}

void ViewerLoop::writeWindow(const std::filesystem::path& file) {
    if (!frame.contents) {
        throw Error(ExitCode::NoDevice, "this window's contents cannot be read back");
    }
    writeDisplayed(file, *frame.contents);
    log.write("window-screenshot", {{"file", file.string()}});
}

void ViewerLoop::serve(Moment moment) {
    for (const Command& command : commands.take(moment)) {
        attempt([&] { std::visit([&](const auto& asked) { serve(asked); }, command); });
    }
}

void ViewerLoop::serve(const ToggleFullScreen&) {
    window.toggleFullScreen();
    log.write("fullscreen");
}

void ViewerLoop::serve(const Minimise&) {
    window.minimise();
    log.write("minimised");
}

void ViewerLoop::serve(const ReadFilesAgain&) {
    files.compileAgain();
    open(state.sceneFile);
}

void ViewerLoop::serve(const SaveScene&) {
    const std::filesystem::path path = freeName(".", "scene", ".json");
    writeScene(path, state.scene, picture.size());
    log.write("saved", {{"file", path.string()}});
    say(state.animation.seconds == 0.0 || !isAnimated(state)
            ? fmt::format("saved {}", path.string())
            : fmt::format("saved {}; it is seen at {} s: raytorus render --time", path.string(),
                          state.animation.seconds));
}

void ViewerLoop::serve(const CopyText& asked) {
    window.setClipboard(asked.text);
    log.write("copied", {{"text", asked.text}});
    say("copied: " + asked.text);
}

void ViewerLoop::serve(const ShowTime& asked) {
    state.animation.seconds = asked.seconds;
    picture.renew();
}

void ViewerLoop::serve(const TakeApart& asked) {
    state.pick = picture.takeApart(asked, state, trace::deviceWords(options.device.context, ""));
    log.write("picked", {{"x", static_cast<long long>(asked.x)},
                         {"y", static_cast<long long>(asked.y)},
                         {"command", state.pick->command},
                         {"text", state.pick->text}});
    frames.need();
}

}  // namespace

void runViewer(const ViewerOptions& options) {
    State state = firstState(options);
    const int width = options.width > 0 ? options.width : state.scene.imageWidth;
    const int height = options.height > 0 ? options.height : state.scene.imageHeight;
    Window window(fmt::format("{} - raytorus", std::filesystem::path(options.scene).filename().string()),
                  width, height);
    options::DeviceOptions device = options.device;
    device.context.instanceExtensions = Window::instanceExtensions();
    device.context.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    options::withDevice(
        device, [&](gpu::Context& context) { ViewerLoop(options, window, context, std::move(state)).run(); });
}

}  // namespace raytorus::viewer
