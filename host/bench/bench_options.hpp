// SPDX-License-Identifier: MIT
// The command line of raytorus-bench.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measure.hpp"
#include "options/device_options.hpp"

namespace raytorus::bench {

inline constexpr const char* programName = "raytorus-bench";

struct BenchOptions {
    std::vector<Workload> workloads;
    std::vector<TimedMethod> methods;
    std::vector<trace::Query> queries;
    MeasureOptions measure;
    bool list = false;
    bool isa = false;
    bool groups = false;
    std::string family;  ///< of the AMD GPU that --isa compiles for, as radv calls it
    std::string json;    ///< files; empty: none
    std::string html;
    std::string against;
    options::DeviceOptions device;
};

/// Nothing if there is nothing to do: --help and --version have been answered. Throws Error{Usage}.
std::optional<BenchOptions> parseOptions(const std::vector<std::string>& arguments);

}  // namespace raytorus::bench
