// SPDX-License-Identifier: MIT
#include "viewer/golden_view.hpp"

#include <algorithm>

#include "compare/compare.hpp"
#include "compare/difference.hpp"
#include "golden/golden_set.hpp"
#include "image/image_io.hpp"
#include "render/renderer.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {

Golden readGolden(const std::filesystem::path& file) {
    return {file.filename().string(), image::readImage(file), 1};
}

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

}  // namespace raytorus::viewer
