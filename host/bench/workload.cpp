// SPDX-License-Identifier: MIT
#include "bench/workload.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

namespace raytorus::bench {
namespace {

constexpr float minorRadii[] = {0.01F, 0.1F, 0.25F, 0.5F, 0.9F};
constexpr double nearDistance = 3.0;
constexpr double farDistance = 1000.0;
constexpr int hitPercents[] = {5, 30, 50, 80};

}  // namespace

std::string Workload::name() const {
    return fmt::format("{}{}/{:g}/{}/{}", mode == Mode::Streamed ? "stream-" : "",
                       pattern == Pattern::Tiles ? "tiles" : "scattered", minorRadius,
                       distance == nearDistance ? "near" : "far", hitPercent);
}

std::string nameOf(trace::Query query) {
    switch (query) {
        case trace::Query::Any:
            return "any";
        case trace::Query::All:
            return "all";
        case trace::Query::Nearest:
            break;
    }
    return "nearest";
}

std::vector<Workload> allWorkloads() {
    std::vector<Workload> workloads;
    for (const Pattern pattern : {Pattern::Tiles, Pattern::Scattered}) {
        for (const double distance : {nearDistance, farDistance}) {
            for (const float radius : minorRadii) {
                for (const int percent : hitPercents) {
                    workloads.push_back({Mode::Made, pattern, radius, distance, percent});
                }
            }
        }
    }
    for (const Pattern pattern : {Pattern::Tiles, Pattern::Scattered}) {
        workloads.push_back({Mode::Streamed, pattern, 0.25F, nearDistance, 30});
    }
    return workloads;
}

bool isQuick(const Workload& workload) {
    const bool middling = workload.minorRadius == 0.1F || workload.minorRadius == 0.5F;
    const bool usual = workload.hitPercent == 30 || workload.hitPercent == 50;
    return workload.mode == Mode::Streamed || (middling && usual && workload.distance == nearDistance);
}

bool fits(const std::string& name, std::span<const std::string> patterns) {
    return patterns.empty() || std::ranges::any_of(patterns, [&name](const std::string& pattern) {
               return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
           });
}

}  // namespace raytorus::bench
