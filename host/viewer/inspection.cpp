// SPDX-License-Identifier: MIT
#include "viewer/inspection.hpp"

#include <fmt/format.h>

namespace raytorus::viewer {
namespace {

bool isAnalysed(View view) {
    return view == View::Surface || view == View::Reference;
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
    if (state.view == View::Golden && goldenStale) {
        goldenStale = false;  // first, so that what fails is told once
        updateGolden(state, shaders);
        return true;
    }
    return false;
}

bool Inspection::updateAnalysis(State& state, Pictures& pictures) {
    Statistics& statistics = state.statistics;
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

bool Inspection::complete(const State& state) const {
    if (isAnalysed(state.view)) {
        return !analysisStale && state.statistics.analysed == 1.0;
    }
    return state.view != View::Golden || !goldenStale;
}

}  // namespace raytorus::viewer
