// SPDX-License-Identifier: MIT
// raytorus render: a scene file to a picture file.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "cli/command.hpp"
#include "cli/picture_writer.hpp"
#include "cli/render_stats.hpp"
#include "core/console.hpp"
#include "core/file.hpp"
#include "image/channels.hpp"
#include "image/image_io.hpp"
#include "options/device_options.hpp"
#include "options/frame_options.hpp"
#include "options/method_option.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "options/progress.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "scene/scene_json.hpp"
#include "truth/truth.hpp"

namespace raytorus::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* renderFooter = R"(The picture:
  .png  8 bit, sRGB, the colour alone
  .exr  linear float32, in these channels, of which all but the colour belong to the ray through the middle of the
        pixel; in brackets, what they are where nothing is hit:
{}
Examples:
  raytorus render scenes/ring.json -o ring.png
  raytorus render scenes/chain.json -o chain.exr --route compute --stats text
  raytorus render scenes/chain.json -o big.png --size 3840x2160 --spp 16
  raytorus render scenes/thin.json -o closed_form.png --method closed-form
  raytorus render scenes/turntable.json -o frame-###.png --frames 288 --fps 24)";

// A line for each quantity of an EXR.
std::string channelLines() {
    std::string lines;
    for (const image::Quantity& quantity : image::quantities) {
        if (!quantity.isOfTruth()) {
            lines += fmt::format("        {:<32}  {} ({})\n",
                                 fmt::format("{}", fmt::join(quantity.channels(), " ")), quantity.meaning,
                                 quantity.onMiss);
        }
    }
    return lines;
}

struct RenderCommand {
    std::string scene;
    std::string output;
    std::string size;
    std::string samples = "1";
    std::string route = "fragment";
    std::string stats;
    options::FrameOptions frames;
    render::RenderOptions options;
    std::string method;
    bool exact = false;  // by the reference
    options::DeviceOptions device;
};

// Seconds since the last call.
class StopWatch {
public:
    double lap() {
        const Clock::time_point now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(last, now)).count();
    }

private:
    Clock::time_point last = Clock::now();
};

std::string lowerExtension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return extension;
}

void requireFinite(const image::Image& picture) {
    const auto channels = static_cast<std::size_t>(picture.channelCount());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (!image::isFinite(picture.pixels[i])) {
            const std::size_t pixel = i / channels;
            const auto width = static_cast<std::size_t>(picture.width);
            throw Error(
                ExitCode::NonFinite,
                fmt::format("the picture holds {} in channel {} of pixel ({}, {}); nothing was written",
                            picture.pixels[i], picture.channelNames[i % channels], pixel % width,
                            pixel / width));
        }
    }
}

void readOptions(RenderCommand& command) {
    if (!command.size.empty()) {
        std::tie(command.options.width, command.options.height) = options::sizeOption(command.size);
    }
    command.options.samplesPerSide = options::samplesOption(command.samples, 64);
    command.options.route = options::routeOption(command.route);
    if (!command.stats.empty() && command.stats != "text" && command.stats != "json") {
        throw Error(ExitCode::Usage, fmt::format("--stats takes text or json, not \"{}\"", command.stats));
    }
    const std::string extension = lowerExtension(command.output);
    if (extension != ".exr" && extension != ".png") {
        throw Error(ExitCode::Usage,
                    fmt::format("--output must end in .exr or .png, not \"{}\"", command.output));
    }
    command.options.aovs = extension == ".exr";
    if (command.frames.sequence() && (!command.stats.empty() || command.options.repeats > 1)) {
        throw Error(ExitCode::Usage, "--stats and --repeat are for one picture, not for --frames");
    }
    command.exact = options::isReference(command.method, command.device);
    if (command.exact && !command.stats.empty()) {
        throw Error(ExitCode::Usage, "--stats tells of a device, and --method reference has none");
    }
    if (!command.exact) {
        command.options.shaders = options::shadersOf(command.method, command.device);
    }
}

image::Image renderExactly(const scene::Scene& scene, const render::RenderOptions& options) {
    const auto [width, height] = render::pictureSize(scene, options);
    truth::TruthOptions exact;
    exact.samplesPerSide = options.samplesPerSide;
    exact.aovs = options.aovs;
    exact.progress = options.progress;
    return truth::renderTruth(scene, width, height, exact);
}

using Draw = std::function<image::Image(const scene::Scene&, const render::RenderOptions&)>;

// Frame k is written while frame k + 1 is drawn.
void renderFrames(const RenderCommand& command, const scene::Scene& scene,
                  const std::vector<options::SequenceFrame>& frames, const Draw& draw) {
    options::Progress progress(fmt::format("rendering {} frames", frames.size()));
    PictureWriter writer(1, image::writeImage);
    render::RenderOptions options = command.options;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        options.progress = [&](double done) {
            progress.show((static_cast<double>(k) + done) / static_cast<double>(frames.size()));
        };
        image::Image picture = draw(scene::sceneAt(scene, frames[k].seconds), options);
        requireFinite(picture);
        writer.write(frames[k].output, std::move(picture));
    }
    writer.finish();
}

void renderSequence(const RenderCommand& command, const scene::Scene& scene,
                    const std::vector<options::SequenceFrame>& frames) {
    if (command.exact) {
        renderFrames(command, scene, frames, renderExactly);
        return;
    }
    options::withDevice(command.device, [&](gpu::Context& context) {
        render::PipelineStore pipelines;
        renderFrames(command, scene, frames, [&](const scene::Scene& moment, render::RenderOptions options) {
            options.pipelines = &pipelines;
            return render::render(context, moment, options).picture;
        });
    });
}

// What has been measured so far of a single picture.
struct Measured {
    Clock::time_point begin = Clock::now();
    StopWatch watch;
    RenderStats stats;
};

image::Image renderOnDevice(const RenderCommand& command, const scene::Scene& scene,
                            const render::RenderOptions& options, Measured& measured) {
    render::RenderResult result;
    options::withDevice(command.device, [&](gpu::Context& context) {
        measured.stats.instance = measured.watch.lap();
        measured.stats.device = context.info();
        result = render::render(context, scene, options);
    });
    measured.stats.render = result.times;
    measured.watch.lap();
    return std::move(result.picture);
}

void renderPicture(const RenderCommand& command, const scene::Scene& scene, Measured& measured) {
    RenderStats& stats = measured.stats;
    render::RenderOptions options = command.options;
    image::Image picture;
    {
        options::Progress progress("rendering");
        options.progress = [&progress](double done) { progress.show(done); };
        picture =
            command.exact ? renderExactly(scene, options) : renderOnDevice(command, scene, options, measured);
    }
    requireFinite(picture);
    image::writeImage(command.output, picture);
    stats.write = measured.watch.lap();
    stats.route = options.route;
    stats.width = picture.width;
    stats.height = picture.height;
    stats.samplesPerPixel = options.samplesPerSide * options.samplesPerSide;
    stats.total = std::chrono::duration<double>(Clock::now() - measured.begin).count();
    if (!command.stats.empty()) {
        print("{}\n", command.stats == "json" ? statsJson(stats) : statsText(stats));
    }
}

ExitCode runRender(RenderCommand command) {
    Measured measured;
    readOptions(command);
    const std::vector<options::SequenceFrame> frames = options::framesOf(command.frames, command.output);
    const scene::Scene scene = scene::readScene(command.scene);
    if (command.frames.moves() && !scene.turntable) {
        throw Error(ExitCode::Usage,
                    fmt::format("{} has no animation, and so no other moments for --time and --frames",
                                command.scene));
    }
    measured.stats.read = measured.watch.lap();
    for (const options::SequenceFrame& frame : frames) {
        requireWritable(frame.output);
    }
    if (command.frames.sequence()) {
        renderSequence(command, scene, frames);
    } else {
        renderPicture(command, scene::sceneAt(scene, frames.front().seconds), measured);
    }
    return ExitCode::Ok;
}

}  // namespace

void addRenderCommand(CLI::App& app, Action& action) {
    const auto command = std::make_shared<RenderCommand>();
    CLI::App* sub = app.add_subcommand("render", "Render a scene file to a picture");
    sub->add_option("scene", command->scene, "The scene, a JSON file (docs/scenes.md)")
        ->required()
        ->option_text("SCENE.json REQUIRED");
    sub->add_option("-o,--output", command->output, "The picture: .exr or .png")
        ->required()
        ->option_text("FILE REQUIRED");
    sub->add_option("--route", command->route, "The pipeline that runs the shaders")
        ->option_text("fragment|compute [fragment]");
    sub->add_option("--size", command->size, "Size of the picture instead of the scene's")
        ->option_text("WxH");
    sub->add_option("--spp", command->samples, "Samples a pixel, on a regular grid: a square number")
        ->option_text("N [1]");
    sub->add_option("--stats", command->stats, "Print where the time went")->option_text("text|json");
    sub->add_option("--repeat", command->options.repeats,
                    "Render so many times and let --stats show the fastest, without what happens only once")
        ->check(options::wholeNumber(1, 1000000))
        ->option_text("N [1]");
    options::addFrameOptions(*sub, command->frames);
    options::addMethodOrReferenceOption(*sub, command->method);
    options::addDeviceOptions(*sub, command->device);
    sub->footer(fmt::format(renderFooter, channelLines()));
    sub->callback([command, &action] { action = [command] { return runRender(*command); }; });
}

}  // namespace raytorus::cli
