// SPDX-License-Identifier: MIT
#include "golden/golden_check.hpp"

#include <fmt/format.h>

#include "golden/golden_folder.hpp"
#include "image/image_io.hpp"
#include "render/scene_json.hpp"

namespace raytorus::golden {

namespace {

// Margins and tolerances are both proportional to the rounding.
void loosen(image::Image& truth, float factor) {
    for (std::size_t channel = 0; channel < truth.channelNames.size(); ++channel) {
        const std::string& name = truth.channelNames[channel];
        const bool margin = name.starts_with("margin");
        if (!margin && !name.starts_with("tolerance.")) {
            continue;
        }
        for (std::size_t i = channel; i < truth.pixels.size(); i += truth.channelNames.size()) {
            truth.pixels[i] = margin ? truth.pixels[i] / factor : truth.pixels[i] * factor;
        }
    }
}

}  // namespace

void prepare(const gpu::Context& context, const Set& set, const Case& row, render::Route route,
             const render::ShaderSource& shaders, render::PipelineStore& pipelines) {
    try {
        render::preparePipeline(context, pipelines, render::readScene(set.scene(row)),
                                {route, row.samplesPerSide, shaders}, render::RenderOptions().aovs);
    } catch (const Error&) {
        return;
    }
}

image::Image draw(gpu::Context& context, const Set& set, const Case& row, render::Route route,
                  const render::ShaderSource& shaders, render::PipelineStore* pipelines) {
    render::RenderOptions options;
    options.pipelines = pipelines;
    options.route = route;
    options.samplesPerSide = row.samplesPerSide;
    options.shaders = shaders;
    return render::render(context, render::readScene(set.scene(row)), options).picture;
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
        image::CompareRules rules;
        rules.allowedPixels = allowedPixels;
        image::Comparison comparison = image::compare(expected, actual, rules);
        result.exitCode = comparison.exitCode();
        result.report = image::reportCase(label, std::move(expected), actual, std::move(comparison));
    } catch (const Error& error) {
        result.exitCode = error.exitCode;
        result.report.name = label;
        result.report.sentence = error.what();
        result.report.actual = actual;
    }
    return result;
}

std::string bitsFault(const Set& set, const Case& row, const image::Image& actual) {
    const std::map<std::string, std::string> bits = readBits(set);
    const auto recorded = bits.find(row.name);
    if (recorded == bits.end()) {
        return fmt::format("{}: nothing about {}", set.bits().string(), row.name);
    }
    if (recorded->second != pictureHash(actual)) {
        return fmt::format(
            "{}: other bits than those recorded, though the device is a CPU; if the shaders were to change "
            "them: "
            "raytorus golden bits --reason \"...\"",
            row.name);
    }
    return "";
}

}  // namespace raytorus::golden
