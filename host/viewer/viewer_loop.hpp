// SPDX-License-Identifier: MIT
// The viewer's loop: from what happens to what is shown, round by round. What it does with files and input is
// in viewer_loop.cpp, what it draws in viewer_drawing.cpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "viewer/change_log.hpp"
#include "viewer/edited_shaders.hpp"
#include "viewer/event_log.hpp"
#include "viewer/frame.hpp"
#include "viewer/gui.hpp"
#include "viewer/inspection.hpp"
#include "viewer/method_list.hpp"
#include "viewer/pictures.hpp"
#include "viewer/pointer.hpp"
#include "viewer/swapchain.hpp"
#include "viewer/view_pass.hpp"
#include "viewer/viewer_options.hpp"

namespace raytorus::viewer {

/// Rounds that are drawn after an input, until ImGui has settled.
constexpr int uiFrames = 3;

class ViewerLoop {
public:
    /// All but the last two are kept by reference.
    ViewerLoop(const ViewerOptions& viewerOptions, Window& shownWindow, gpu::Context& gpuContext,
               State firstState, std::vector<MethodEntry> methodList);
    /// Until the window is closed.
    void run();

private:
    using Clock = std::chrono::steady_clock;

    static VkExtent2D nonZero(VkExtent2D extent);

    static compile::FileWatch watchFile(const std::string& file);

    [[nodiscard]] double clock() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
    [[nodiscard]] bool isScript() const;

    [[nodiscard]] bool animated() const { return state.scene.turntable.has_value(); }
    void say(const std::string& text);

    // A fault of what was asked for is told, and the viewer goes on; only a lost device and its like end it.
    template <typename Function>
    void attempt(const Function& function) {
        try {
            function();
        } catch (const Error& error) {
            const bool fatal =
                error.exitCode == ExitCode::DeviceLost || error.exitCode == ExitCode::OutOfMemory;
            if (fatal || isScript()) {
                throw;
            }
            say(error.what());
        }
    }

    void round();
    void takeTime();
    void take(const InputEvent& event);
    void open(const std::string& file);
    void followFiles();
    // What keys and panels have asked for.
    void serve();
    void serveAtRest();
    void noteSize(VkExtent2D size);
    [[nodiscard]] const trace::ShaderSource& shadersOf(const Side& side) const;
    [[nodiscard]] ShaderVersion versionOf(const Side& side) const;

    void updatePictures(VkExtent2D size);
    void notePicture();
    [[nodiscard]] view_io::ViewPush viewPush() const;
    void drawView();
    [[nodiscard]] bool fills() const;
    [[nodiscard]] VkRect2D picturePlace(VkExtent2D size) const;
    void showFrame();
    void saveWindow(const std::filesystem::path& path, const FrameCopy* copy);
    void noteFrame();
    void pick(std::pair<int, int> pixel);
    void saveScene();
    void saveScreenshot(const std::filesystem::path& path);
    // Everything that a script waits for is there, this frame included.
    [[nodiscard]] bool scriptDone() const;
    void finishScript();
    void finishSequence();

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
    ChangeLog changes;
    Inspection inspection;
    Pointer pointer;
    compile::FileWatch sceneWatch;
    std::unique_ptr<EditedShaders> edited;

    Clock::time_point begin = Clock::now();
    double lastRound = 0.0;
    double lastFrame = 0.0;
    double roundBegin = 0.0;
    double roundDrawing = 0.0;  // seconds of this round that went into pictures
    VkExtent2D lastSize{};
    bool hidden = false;
    bool unshown = false;  // the last frame was not taken by the window
    std::tuple<View, double, int> lastLooks{View::Shaded, -1.0, 0};
    bool viewStale = true;
    bool windowWritten = false;
    int dirtyFrames = uiFrames;
    int framesShown = 0;
    std::size_t sequenceWritten = 0;
    int movedFrames = 0;  // of the moving pictures that have not been told of
    double movedSeconds = 0.0;
};

}  // namespace raytorus::viewer
