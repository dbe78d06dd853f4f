// SPDX-License-Identifier: MIT
#include "mutate/golden_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>

#include "golden/golden_check.hpp"

namespace raytorus::mutate {

GoldenSuite::GoldenSuite() : set(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "golden") {
    for (std::size_t i = 0; i < set.cases().size(); ++i) {
        trials.push_back({i, render::Route::Fragment});
        trials.push_back({i, render::Route::Compute});
    }
}

std::vector<std::size_t> GoldenSuite::trialsInOrder() {
    const std::scoped_lock lock(mutex);
    std::vector<std::size_t> order(trials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [this](std::size_t i) { return trials[i].catches; });
    return order;
}

GoldenVerdict GoldenSuite::caught(gpu::Context& context, const trace::ShaderSource& shaders) {
    const bool bitsPromised = context.info().type == "CPU";
    render::PipelineStore pipelines;
    GoldenVerdict verdict;
    for (const std::size_t i : trialsInOrder()) {
        const golden::Case& row = set.cases()[trials[i].row];
        const render::Route route = trials[i].route;
        const std::string label =
            fmt::format("{}_{}", row.name, route == render::Route::Fragment ? "fragment" : "compute");
        const image::Image picture = golden::draw(context, set, row, route, shaders, &pipelines);
        if (bitsPromised && !verdict.bits && !golden::bitsFault(set, row, picture).empty()) {
            verdict.bits = label;
        }
        if (!golden::check(set, row, label, picture).report.passed) {
            verdict.truth = label;
            const std::scoped_lock lock(mutex);
            ++trials[i].catches;
            break;
        }
    }
    return verdict;
}

}  // namespace raytorus::mutate
