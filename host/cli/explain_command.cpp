// SPDX-License-Identifier: MIT
// raytorus explain: one ray, step by step.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "core/console.hpp"
#include "core/file.hpp"
#include "explain/explain.hpp"
#include "explain/json.hpp"
#include "explain/pixel.hpp"
#include "explain/svg.hpp"
#include "explain/text.hpp"
#include "options/device_options.hpp"
#include "options/numbers.hpp"
#include "options/option_text.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::cli {
namespace {

constexpr const char* explainFooter =
    R"(What the shaders compute in float32, each step of the closed form and each hit, beside the exact value and how far
it is off. The equations are those of docs/math.md. Numbers may be decimal, inf or nan; bad input is explained, too.

Examples:
  raytorus explain --torus 1,0.25 --origin -3,0.5,0.1 --direction 1,0,0
  raytorus explain --torus 1,0.25 --origin 3,0,0 --direction -1,0,0.05 --t-max 3 --json
  raytorus explain --torus 1,0.35 --origin -2,0.4,0.25 --direction 1,0,-0.1 --svg ray.svg
  raytorus explain --scene scenes/ring.json --pixel 480,300
  raytorus explain --replay "0x1p+0 0x1p-2  -0x1p+1 0x0p+0 0x0p+0 0x0p+0  0x1p+0 0x0p+0 0x0p+0 inf"

Ends with 0 whether the library is right or not: the last line says which.)";

struct ExplainCommand {
    std::string torus;
    std::string origin;
    std::string direction;
    std::string tMin = "0";
    std::string tMax = "inf";
    std::string replay;
    std::string scene;
    std::string pixel;
    std::string size;
    bool json = false;
    std::string svg;
    options::DeviceOptions device;
};

// Numbers that are no torus or no ray are explained, but text that is no number is not.
template <std::size_t Count>
std::array<float, Count> numbersOf(const char* option, const char* what, const std::string& text) {
    const std::optional<std::array<float, Count>> numbers = options::parseFloats<Count>(text);
    if (!numbers) {
        throw Error(ExitCode::Usage, fmt::format("{} takes {}, not \"{}\"", option, what, text));
    }
    return *numbers;
}

std::pair<int, int> pixelOf(const std::string& text, int width, int height) {
    const auto numbers = options::parsePair(text);
    const auto isPixel = [](float number, int count) {
        return number >= 0.0F && number < static_cast<float>(count) && number == std::floor(number);
    };
    if (!numbers || !isPixel(numbers->first, width) || !isPixel(numbers->second, height)) {
        throw Error(ExitCode::Usage, fmt::format("--pixel takes X,Y from 0,0 to {},{}, not \"{}\"", width - 1,
                                                 height - 1, text));
    }
    return {static_cast<int>(numbers->first), static_cast<int>(numbers->second)};
}

// The ray through a pixel, and the torus that it hits first, or else the one that it passes nearest to.
explain::PixelRay pixelRay(const std::string& scenePath, const std::string& pixel, const std::string& size) {
    const scene::Scene scene = scene::readScene(scenePath);
    const auto [width, height] =
        size.empty() ? std::pair(scene.imageWidth, scene.imageHeight) : options::sizeOption(size);
    const auto [x, y] = pixelOf(pixel, width, height);
    explain::PixelRay result = explain::pixelRay(scene, width, height, x, y);
    result.sentence = fmt::format("pixel ({}, {}) of {}: {}", x, y, scenePath, result.sentence);
    return result;
}

// sentence: what is to be said first, if anything.
reference::TorusAndRay torusAndRay(const ExplainCommand& command, std::string& sentence) {
    if (!command.replay.empty()) {
        return options::replayOption(command.replay);
    }
    if (!command.scene.empty()) {
        const explain::PixelRay found = pixelRay(command.scene, command.pixel, command.size);
        sentence = found.sentence;
        return {found.torus, found.ray};
    }
    for (const auto& [option, value] :
         {std::pair("--torus", &command.torus), std::pair("--origin", &command.origin),
          std::pair("--direction", &command.direction)}) {
        if (value->empty()) {
            throw Error(ExitCode::Usage,
                        fmt::format("{} is required, or --replay, or --scene and --pixel", option));
        }
    }
    const auto [R, r] = numbersOf<2>("--torus", "the major and the minor radius as R,r", command.torus);
    options::requireTorusInRange("--torus", {R, r}, command.torus);
    const auto origin = numbersOf<3>("--origin", "a point as x,y,z", command.origin);
    const auto direction = numbersOf<3>("--direction", "a vector as x,y,z", command.direction);
    reference::TorusAndRay result{{R, r}, {}};
    std::copy(origin.begin(), origin.end(), result.ray.origin);
    std::copy(direction.begin(), direction.end(), result.ray.direction);
    result.ray.tMin = numbersOf<1>("--t-min", "a number", command.tMin)[0];
    result.ray.tMax = numbersOf<1>("--t-max", "a number", command.tMax)[0];
    return result;
}

ExitCode runExplain(const ExplainCommand& command) {
    std::string sentence;
    const auto [torus, ray] = torusAndRay(command, sentence);
    std::optional<OutputFile> picture;
    if (!command.svg.empty()) {
        options::refuseToOverwrite("--svg", command.svg, command.scene);
        picture.emplace(command.svg);
    }
    explain::Explanation explanation;
    options::withDevice(command.device, [&, &torus = torus, &ray = ray](gpu::Context& context) {
        explanation = explain::explain(context, torus, ray, command.device.shaders());
    });
    if (picture) {
        picture->write(explain::svgOf(explanation));
        picture->commit();
    }
    if (command.json) {
        print("{}\n", explain::jsonOf(explanation));
    } else {
        print("{}{}", sentence.empty() ? "" : sentence + "\n\n", explain::textOf(explanation));
    }
    return ExitCode::Ok;
}

}  // namespace

void addExplainCommand(CLI::App& app, Action& action) {
    const auto command = std::make_shared<ExplainCommand>();
    CLI::App* sub = app.add_subcommand("explain", "Explain one ray: every step, beside the exact value");
    sub->add_option("--torus", command->torus, "Major and minor radius")->option_text("R,r");
    sub->add_option("--origin", command->origin, "Where the ray begins to count")->option_text("X,Y,Z");
    sub->add_option("--direction", command->direction, "Where it goes, of any length")->option_text("X,Y,Z");
    sub->add_option("--t-min", command->tMin, "Start, in lengths of the direction")->option_text("T [0]");
    sub->add_option("--t-max", command->tMax, "End, in lengths of the direction")->option_text("T [inf]");
    CLI::Option* replay =
        sub->add_option("--replay", command->replay,
                        "Instead of these a ray as raytorus-verify prints it: R r, origin, tMin, "
                        "direction, tMax")
            ->option_text("\"10 NUMBERS\"");
    CLI::Option* scene =
        sub->add_option("--scene", command->scene, "Instead of these the ray through a pixel of a scene")
            ->option_text("SCENE.json");
    CLI::Option* pixel = sub->add_option("--pixel", command->pixel, "Which one, from the upper left corner")
                             ->option_text("X,Y")
                             ->needs(scene);
    scene->needs(pixel)->excludes(replay);
    sub->add_option("--size", command->size, "Size of its picture instead of the scene's")
        ->option_text("WxH")
        ->needs(scene);
    for (const char* name : {"--torus", "--origin", "--direction", "--t-min", "--t-max"}) {
        replay->excludes(sub->get_option(name));
        scene->excludes(sub->get_option(name));
    }
    sub->add_flag("--json", command->json, "Print one JSON object");
    sub->add_option("--svg", command->svg, "Draw the section and the quartic, too")->option_text("FILE");
    options::addDeviceOptions(*sub, command->device);
    sub->footer(explainFooter);
    sub->callback([command, &action] { action = [command] { return runExplain(*command); }; });
}

}  // namespace raytorus::cli
