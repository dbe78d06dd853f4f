// SPDX-License-Identifier: MIT
#include "golden_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "image/difference.hpp"
#include "image/image_io.hpp"
#include "render/scene_json.hpp"

namespace raytorus::test {

namespace fs = std::filesystem;

image::Image renderGolden(gpu::Context& context, const GoldenCase& row, render::Route route) {
    const fs::path scenes = fs::path(RAYTORUS_SOURCE_DIR) / "scenes";
    render::RenderOptions options;
    options.route = route;
    options.width = goldenWidth;
    options.height = goldenHeight;
    return render::render(context, render::readScene(scenes / fmt::format("{}.json", row.name)), options)
        .picture;
}

image::CompareRules goldenRules(const GoldenCase& row, const gpu::DeviceInfo& device) {
    image::CompareRules rules;
    if (device.type != "CPU") {
        rules.defaultRule = {row.gpuTolerance, row.gpuTolerance};
        rules.allowedPixels = row.gpuAllowedPixels;
    }
    return rules;
}

image::ReportCase checkGolden(const fs::path& folder, const GoldenCase& row, const std::string& label,
                              const image::Image& actual, const image::CompareRules& rules) {
    image::ReportCase result;
    try {
        image::Image expected = image::readImage(folder / fmt::format("{}.exr", row.name));
        image::Comparison comparison = image::compare(expected, actual, rules);
        result = image::reportCase(label, std::move(expected), actual, std::move(comparison));
    } catch (const Error& error) {
        result.name = label;
        result.sentence = error.what();
        result.actual = actual;
    }
    if (!result.passed) {
        result.sentence += fmt::format(
            " (after a look at the picture: raytorus-golden renew {} --reason \"...\")", row.name);
    }
    return result;
}

std::vector<std::string> strayGoldens(const fs::path& folder) {
    std::vector<std::string> faults;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool known =
            name == "README.md" ||
            std::any_of(goldenCases.begin(), goldenCases.end(), [&name](const GoldenCase& row) {
                return name == fmt::format("{}.exr", row.name) || name == fmt::format("{}.json", row.name);
            });
        if (!known) {
            faults.push_back(
                fmt::format("\"{}\" is in the folder of goldens, but no case has that name", name));
        }
    }
    return faults;
}

void leaveEvidence(const fs::path& folder, const image::ReportCase& result) {
    fs::create_directories(folder);
    if (result.actual) {
        image::writeImage(folder / "actual.exr", *result.actual);
    }
    if (result.expected) {
        image::writeImage(folder / "expected.exr", *result.expected);
    }
    if (result.comparison && result.comparison->verdict == image::Verdict::Differ) {
        image::writeImage(folder / "difference.png",
                          image::differenceImage(*result.expected, *result.actual, result.comparison->rules));
    }
    image::writeReport(folder / "report.html", std::span(&result, 1));
}

}  // namespace raytorus::test
