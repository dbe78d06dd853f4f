// SPDX-License-Identifier: MIT
#include "golden/golden_check.hpp"

#include <fmt/format.h>

#include "golden/golden_folder.hpp"
#include "image/channels.hpp"
#include "image/image_io.hpp"
#include "scene/scene_json.hpp"

namespace raytorus::golden {

namespace {

// Margins and tolerances are both proportional to the rounding.
void loosen(image::Image& truth, float factor) {
    for (std::size_t channel = 0; channel < truth.channelNames.size(); ++channel) {
        const image::Quantity* const quantity = image::findQuantity(truth.channelNames[channel]);
        if (quantity == nullptr || !quantity->isOfTruth()) {
            continue;
        }
        const bool margin = quantity->kind == image::ChannelKind::Margin;
        for (std::size_t i = channel; i < truth.pixels.size(); i += truth.channelNames.size()) {
            truth.pixels[i] = margin ? truth.pixels[i] / factor : truth.pixels[i] * factor;
        }
    }
}

}  // namespace

void prepare(const gpu::Context& context, const Set& set, const Case& row, render::Route route,
             const trace::ShaderSource& shaders, render::PipelineStore& pipelines) {
    try {
        render::preparePipeline(context, pipelines, scene::readScene(set.scene(row)),
                                {route, row.samplesPerSide, shaders}, render::RenderOptions().aovs);
    } catch (const Error&) {
        return;
    }
}

void requireSound(const Set& set) {
    if (const std::string fault = renewalFault(set); !fault.empty()) {
        throw Error(ExitCode::File, fault);
    }
    for (const Case& row : set.cases()) {
        static_cast<void>(scene::readScene(set.scene(row)));
        if (const std::string fault = truthFault(set, row); !fault.empty()) {
            throw Error(ExitCode::File, fault);
        }
    }
}

image::Image draw(gpu::Context& context, const Set& set, const Case& row, render::Route route,
                  const trace::ShaderSource& shaders, render::PipelineStore* pipelines) {
    render::RenderOptions options;
    options.pipelines = pipelines;
    options.route = route;
    options.samplesPerSide = row.samplesPerSide;
    options.shaders = shaders;
    return render::render(context, scene::readScene(set.scene(row)), options).picture;
}

Checked check(const Set& set, const Case& row, const std::string& label, const image::Image& actual,
              int allowedPixels, float toleranceFactor) {
    Checked result;
    try {
        if (const std::string fault = truthFault(set, row); !fault.empty()) {
            throw Error(ExitCode::File, fault);
        }
        image::Image expected = image::readImage(set.truth(row));
        loosen(expected, toleranceFactor);
        compare::CompareRules rules;
        rules.allowedPixels = allowedPixels;
        compare::Comparison comparison = compare::compare(expected, actual, rules);
        result.exitCode = comparison.exitCode();
        result.report = report::reportCase(label, std::move(expected), actual, std::move(comparison));
    } catch (const Error& error) {
        result = unchecked(label, error.exitCode, error.what());
        result.report.actual = actual;
    }
    return result;
}

Checked unchecked(const std::string& label, ExitCode code, const std::string& sentence) {
    Checked result;
    result.exitCode = code;
    result.report.name = label;
    result.report.verdict = "error";
    result.report.sentence = sentence;
    return result;
}

bool isOfOneCase(ExitCode code) {
    return code == ExitCode::File || code == ExitCode::Scene || code == ExitCode::Shader ||
           code == ExitCode::OutOfMemory;
}

ExitCode worse(ExitCode one, ExitCode other) {
    // The order in which a picture passes the gates.
    for (const ExitCode first : {ExitCode::File, ExitCode::Scene, ExitCode::Shader, ExitCode::OutOfMemory,
                                 ExitCode::SizeDiffers, ExitCode::NonFinite, ExitCode::ComparisonFailed}) {
        if (one == first || other == first) {
            return first;
        }
    }
    return one == ExitCode::Ok ? other : one;
}

std::string bitsFault(const Set& set, const Case& row, const image::Image& actual) {
    const std::map<std::string, std::string> bits = readBits(set);
    const auto recorded = bits.find(row.name);
    if (recorded == bits.end()) {
        return fmt::format("{}: nothing about {}", set.bits().string(), row.name);
    }
    if (recorded->second != pictureHash(actual)) {
        return fmt::format("{}: other bits than those recorded, though the device is a CPU", row.name);
    }
    return "";
}

}  // namespace raytorus::golden
