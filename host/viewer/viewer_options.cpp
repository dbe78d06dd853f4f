// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <tuple>

#include "core/console.hpp"
#include "image/image_io.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/program.hpp"
#include "scene/scene_json.hpp"
#include "viewer/keys.hpp"
#include "viewer/viewer.hpp"

namespace raytorus::viewer {
namespace {

constexpr const char* footer =
    R"(With --frames or a screenshot the window closes by itself, once it has shown so many frames and the
picture, with all its samples and all that is worked out about it, is complete. A screenshot is the picture without
panels: .png as the view shows it, .exr with every channel, both the same as raytorus render's.

Exit codes are those of raytorus (docs/cli.md); 8: no display, or no device for it.

Examples:
  raytorus-view scenes/ring.json
  raytorus-view scenes/thin.json --view reference --method closed-form
  raytorus-view scenes/chain.json --wipe closed-form-naive
  raytorus-view scenes/ring.json --edit shaders --wipe raytorus
  raytorus-view scenes/ring.json --size 800x600 --frames 1 --screenshot ring.exr
  raytorus-view scenes/turntable.json --view steps --sequence steps-##.png --frames 48 --fps 24
  xvfb-run raytorus-view scenes/ring.json --view steps --window-screenshot window.png)";

struct Texts {
    std::string size, view = "shaded", route = "fragment", wipe, samples = "4", pick, sequence, rate;
    bool noPanel = false;
    bool listViews = false, listKeys = false;
};

void readWipe(const std::string& text, ViewerOptions& options) {
    const std::size_t at = text.find('@');
    options.wipeMethod = text.substr(0, at);
    if (at == std::string::npos) {
        return;
    }
    const auto number = options::parseFloat(text.substr(at + 1));
    if (!number || !(*number >= 0.0F && *number <= 1.0F)) {
        throw Error(
            ExitCode::Usage,
            fmt::format("--wipe takes METHOD or METHOD@PART with a part of the width from 0 to 1, not \"{}\"",
                        text));
    }
    options.wipeAt = static_cast<double>(*number);
}

void readPick(const std::string& text, ViewerOptions& options) {
    const auto numbers = options::parsePair(text);
    const auto isPixel = [](float number) {
        return number >= 0.0F && number < 16384.0F && number == std::floor(number);
    };
    if (!numbers || !isPixel(numbers->first) || !isPixel(numbers->second)) {
        throw Error(ExitCode::Usage, fmt::format("--pick takes a pixel as X,Y, not \"{}\"", text));
    }
    options.pick = {static_cast<int>(numbers->first), static_cast<int>(numbers->second)};
}

void requireImageName(const char* option, const std::string& path, bool pngAlone) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (!path.empty() && extension != ".png" && (pngAlone || extension != ".exr")) {
        throw Error(ExitCode::Usage, fmt::format("{} must end in .png{}, not \"{}\"", option,
                                                 pngAlone ? "" : " or .exr", path));
    }
}

void readSequence(const Texts& texts, ViewerOptions& options) {
    requireImageName("--sequence", texts.sequence, false);
    if (texts.sequence.empty() && !texts.rate.empty()) {
        throw Error(ExitCode::Usage, "--fps needs --sequence");
    }
    if (!texts.sequence.empty()) {
        const std::string count = options.script.frames > 0 ? std::to_string(options.script.frames) : "";
        if (count.empty()) {
            throw Error(ExitCode::Usage, "--sequence needs --frames");
        }
        options.script.sequence =
            options::framesOf({fmt::format("{}", options.time), count, texts.rate}, texts.sequence);
        options.script.frames = 1;
    }
}

void readTexts(const Texts& texts, ViewerOptions& options) {
    if (!texts.size.empty()) {
        std::tie(options.width, options.height) = options::sizeOption(texts.size);
    }
    const ViewInfo* view = findView(texts.view);
    if (view == nullptr) {
        throw Error(ExitCode::Usage,
                    fmt::format("there is no view \"{}\" (raytorus-view --list-views)", texts.view));
    }
    options.view = view->view;
    options.route = options::routeOption(texts.route);
    options.samplesPerSide = options::samplesOption(texts.samples, 16);
    if (!texts.wipe.empty()) {
        readWipe(texts.wipe, options);
    }
    if (!texts.pick.empty()) {
        readPick(texts.pick, options);
    }
    options.panel = !texts.noPanel;
    readSequence(texts, options);
    requireImageName("--screenshot", options.script.screenshot, false);
    requireImageName("--window-screenshot", options.script.windowScreenshot, true);
    options::refuseSameFile("--screenshot", options.script.screenshot, "--window-screenshot",
                            options.script.windowScreenshot);
    options::refuseToOverwrite("--screenshot", options.script.screenshot, options.golden);
}

void addScriptOptions(CLI::App& app, Script& script, Texts& texts) {
    app.add_option("--frames", script.frames, "Close after so many frames, or pictures of a sequence")
        ->check(options::wholeNumber(1, 1000000000))
        ->option_text("N");
    app.add_option("--screenshot", script.screenshot, "Write the picture, then close")
        ->option_text("FILE.png|.exr");
    app.add_option("--window-screenshot", script.windowScreenshot,
                   "Write the window with its panels, then close")
        ->option_text("FILE.png");
    app.add_option("--sequence", texts.sequence,
                   "Write so many pictures of an animation, numbered where the name has ####, then close")
        ->option_text("FILE-####.png|.exr");
    app.add_option("--fps", texts.rate, "Frames a second of the scene's time, with --sequence")
        ->option_text("F");
}

}  // namespace

std::optional<ViewerOptions> parseOptions(const std::vector<std::string>& arguments) {
    ViewerOptions options;
    options.device.program = programName;
    Texts texts;
    CLI::App app("Look at a scene of tori live: its picture, its mathematics and its errors", programName);
    app.set_version_flag("--version", std::string(version()), "Print the version");
    app.add_option("scene", options.scene, "The scene, a JSON file (docs/scenes.md)")
        ->option_text("SCENE.json");
    app.add_option("--size", texts.size, "Size of the window instead of that of the scene's picture")
        ->option_text("WxH");
    app.add_option("--view", texts.view, "What is shown of the picture, see --list-views")
        ->option_text("NAME [shaded]");
    app.add_option("--method", options.method, "Who intersects, as in raytorus render")
        ->option_text("NAME [raytorus]");
    app.add_option("--edit", options.edit,
                   "Compile the GLSL in this folder, a copy of shaders/, now and whenever it changes")
        ->option_text("DIR");
    app.add_option("--route", texts.route, "The pipeline that runs the shaders")
        ->option_text("fragment|compute [fragment]");
    app.add_option("--wipe", texts.wipe, "Another method on the right, from this part of the width on")
        ->option_text("METHOD[@PART]");
    app.add_option("--spp", texts.samples, "Samples a pixel at rest: a square number")->option_text("N [4]");
    app.add_option("--golden", options.golden, "What the view golden compares with; else the scene's own")
        ->option_text("FILE.exr");
    app.add_option("--time", options.time, "The scene's time at the beginning")
        ->check(options::decimalNumber(-1e6, 1e6))
        ->option_text("SECONDS [0]");
    app.add_flag("--paused", options.paused, "Time stands still until Space is pressed");
    app.add_flag("--no-panel", texts.noPanel, "Begin without the panel (Tab shows it)");
    app.add_flag("--keys", options.help, "Begin with the help on keys");
    app.add_option("--pick", texts.pick, "Take this pixel apart at the beginning")->option_text("X,Y");
    addScriptOptions(app, options.script, texts);
    app.add_flag("--events", options.events, "Print what happens as lines of JSON");
    app.add_flag("--list-views", texts.listViews, "Print the views");
    app.add_flag("--list-keys", texts.listKeys, "Print what keys and pointer do");
    options::addDeviceOptions(app, options.device);
    app.footer(footer);
    if (!options::parse(app, arguments)) {
        return std::nullopt;
    }
    if (texts.listViews || texts.listKeys) {
        print("{}{}", texts.listViews ? viewTable() : "", texts.listKeys ? keyTable() : "");
        return std::nullopt;
    }
    if (!options.device.shaderFolder.empty()) {
        throw Error(ExitCode::Usage, "--shaders: the window compiles what it is given, by --edit DIR");
    }
    if (options.scene.empty()) {
        throw Error(ExitCode::Usage,
                    "a scene is required: raytorus-view SCENE.json (see raytorus-view --help)");
    }
    readTexts(texts, options);
    return options;
}

State firstState(const ViewerOptions& options) {
    State state;
    state.sceneFile = options.scene;
    state.fileScene = scene::readScene(options.scene);
    state.scene = state.fileScene;
    state.view = options.view;
    state.methods = methodList(!options.edit.empty());
    const std::string method = !options.method.empty()       ? options.method
                               : state.methods.back().edited ? "edited"
                                                             : "raytorus";
    const std::string right = !options.wipeMethod.empty() ? options.wipeMethod : "closed-form-naive";
    state.left = {indexOf(state.methods, method), options.route};
    state.right = {indexOf(state.methods, right), options.route};
    state.wipe = !options.wipeMethod.empty();
    state.wipeAt = options.wipeAt;
    state.samplesPerSide = options.samplesPerSide;
    state.animation.seconds = options.time;
    state.animation.playing = !options.paused;
    state.panel = options.panel;
    state.help = options.help;
    return state;
}

}  // namespace raytorus::viewer
