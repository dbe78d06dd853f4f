// SPDX-License-Identifier: MIT
#include "viewer/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/compare.hpp"
#include "compare/difference.hpp"
#include "core/error.hpp"
#include "explain/explain.hpp"
#include "explain/pixel.hpp"
#include "explain/text.hpp"
#include "golden/golden_set.hpp"
#include "image/image_io.hpp"
#include "reference/rays.hpp"
#include "render/renderer.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

bool isAnalysed(PictureView view) {
    return view == PictureView::Surface || view == PictureView::Reference;
}

// The golden picture that a file holds.
Golden readGolden(const std::filesystem::path& file) {
    return {file.filename().string(), image::readImage(file), 1};
}

// The golden picture of a scene that lies in the folder `scenes` of a set of them (docs/golden.md). Nothing
// for other scenes.
std::optional<Golden> findGolden(const std::filesystem::path& scene) {
    const std::filesystem::path folder = std::filesystem::absolute(scene).parent_path().parent_path();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(folder / "cases.json", ignored)) {
        return std::nullopt;
    }
    const golden::Set set(folder);
    for (const golden::Case& row : set.cases()) {
        if (std::filesystem::equivalent(set.scene(row), scene, ignored)) {
            Golden found = readGolden(set.truth(row));
            found.samplesPerSide = row.samplesPerSide;
            return found;
        }
    }
    return std::nullopt;
}

struct GoldenView {
    AnalysisPixels pixels;  // the picture of the differences, compare::differenceImage
    std::string sentence;   // what the comparison comes to
    bool passed = false;
};

// Draws the scene in the golden picture's size and compares.
GoldenView compareWithGolden(gpu::Context& context, const scene::Scene& scene, const Golden& golden,
                             const trace::ShaderSource& shaders, render::Route route) {
    render::RenderOptions options;
    options.route = route;
    options.width = golden.truth.width;
    options.height = golden.truth.height;
    options.samplesPerSide = golden.samplesPerSide;
    options.shaders = shaders;
    const image::Image actual = render::render(context, scene, options).picture;
    const compare::Comparison comparison = compare::compare(golden.truth, actual, {});
    GoldenView view;
    view.sentence = comparison.sentence;
    view.passed = comparison.passed();
    const std::size_t pixels =
        static_cast<std::size_t>(actual.width) * static_cast<std::size_t>(actual.height);
    view.pixels = {actual.width, actual.height, std::vector<float>(4 * pixels, 0.0F)};
    if (comparison.verdict == compare::Verdict::SizeDiffers) {
        return view;
    }
    const image::Image difference = compare::differenceImage(golden.truth, actual, {});
    for (std::size_t i = 0; i < pixels; ++i) {
        view.pixels.values[4 * i] = ANALYSIS_COLOR;
        std::copy_n(&difference.pixels[3 * i], 3, &view.pixels.values[4 * i + 1]);
    }
    return view;
}

// A row for a table of rays whose hits are known, as C++ reads it: hexadecimal floats lose nothing.
std::string testCaseOf(const explain::PixelRay& found, const explain::Explanation& explanation) {
    const reference::Ray& ray = found.ray;
    std::string hits;
    for (const explain::TrueRoot& root : explanation.roots) {
        if (root.isHit()) {
            hits += fmt::format("{}{:a}", hits.empty() ? "" : ", ", reference::toDouble(root.t));
        }
    }
    return fmt::format(
        "{{\"pixel_{}_{}\", {:a}F, {:a}F, {{{{{:a}F, {:a}F, {:a}F}}, {:a}F, {{{:a}F, {:a}F, {:a}F}}, "
        "infinity}}, {{{}}}, ulps}},",
        found.x, found.y, found.torus.majorRadius, found.torus.minorRadius, ray.origin[0], ray.origin[1],
        ray.origin[2], ray.tMin, ray.direction[0], ray.direction[1], ray.direction[2], hits);
}

}  // namespace

Inspection::Inspection(gpu::Context& gpuContext, ViewPass& pass, const EventLog& eventLog)
    : context(&gpuContext), viewPass(&pass), log(&eventLog) {}

void Inspection::openGolden(const std::string& file, const std::filesystem::path& scene) {
    goldenStale = true;
    golden.reset();
    golden = file.empty() ? findGolden(scene) : readGolden(file);
}

void Inspection::forget() {
    analysisStale = true;
    goldenStale = true;
}

bool Inspection::update(State& state, Pictures& pictures, const trace::ShaderSource& shaders) {
    if (!isAnalysed(state.view)) {
        analysis.stop();
        analysisStale = true;
    }
    if (!pictures.settled()) {
        return false;
    }
    if (isAnalysed(state.view)) {
        return updateAnalysis(state, pictures);
    }
    if (state.view == PictureView::Golden && goldenStale) {
        goldenStale = false;  // first, so that what fails is told once
        updateGolden(state, shaders);
        return true;
    }
    return false;
}

bool Inspection::updateAnalysis(State& state, Pictures& pictures) {
    PictureStatistics& statistics = state.statistics;
    if (analysisStale) {
        analysis.start(pictures.scene(), pictures.side(0).readBack(pictures.extent()));
        analysisStale = false;
        statistics.analysed = 0.0;
    }
    AnalysisPixels pixels;
    Analysis::Progress progress;
    if (!analysis.take(pixels, progress)) {
        return false;
    }
    viewPass->setAnalysis(pixels);
    statistics.analysed = progress.part;
    statistics.wrongPixels = progress.wrong;
    statistics.largestError = progress.largest;
    if (progress.part == 1.0) {
        log->write("analysed", {{"wrong", progress.wrong}, {"largest", progress.largest}});
    }
    return true;
}

void Inspection::updateGolden(State& state, const trace::ShaderSource& shaders) {
    sizeOfGolden = {1, 1};
    if (!golden) {
        state.goldenSentence = "this scene has no golden picture (--golden FILE.exr names one)";
        viewPass->setAnalysis({1, 1, std::vector<float>(4, 0.0F)});
        log->write("golden", {{"text", state.goldenSentence}, {"passed", false}});
        return;
    }
    const GoldenView view = compareWithGolden(*context, state.scene, *golden, shaders, state.left.route);
    sizeOfGolden = {static_cast<std::uint32_t>(view.pixels.width),
                    static_cast<std::uint32_t>(view.pixels.height)};
    viewPass->setAnalysis(view.pixels);
    state.goldenSentence = fmt::format("{}: {}", golden->name, view.sentence);
    log->write("golden", {{"text", state.goldenSentence}, {"passed", view.passed}});
}

Pick Inspection::takeApart(const TakeApart& pixel, const Pictures& pictures,
                           const trace::ShaderSource& shaders, const std::string& deviceWords) const {
    const auto [x, y] = pixel;
    const int width = static_cast<int>(pictures.extent().width);
    const int height = static_cast<int>(pictures.extent().height);
    if (x >= width || y >= height) {
        throw Error(ExitCode::Usage,
                    fmt::format("pixel ({}, {}) is outside the picture of {} x {}", x, y, width, height));
    }
    const explain::PixelRay found = explain::pixelRay(pictures.scene(), width, height, x, y);
    const explain::Explanation explanation = explain::explain(*context, found.torus, found.ray, shaders);
    Pick pick;
    pick.x = x;
    pick.y = y;
    pick.text = fmt::format("pixel ({}, {}) of {} x {}: {}\n\n{}", x, y, width, height, found.sentence,
                            explain::textOf(explanation));
    pick.command = fmt::format("raytorus explain{} --replay \"{}\"", deviceWords,
                               reference::hexFloats(found.torus, found.ray));
    pick.testCase = testCaseOf(found, explanation);
    return pick;
}

bool Inspection::complete(const State& state) const {
    if (isAnalysed(state.view)) {
        return !analysisStale && state.statistics.analysed == 1.0;
    }
    return state.view != PictureView::Golden || !goldenStale;
}

}  // namespace raytorus::viewer
