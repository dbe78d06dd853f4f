// SPDX-License-Identifier: MIT
// What a run of the benchmark has found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/correctness.hpp"
#include "bench/timing.hpp"
#include "bench/workload.hpp"

namespace raytorus::bench {

struct MethodResult {
    std::string name;
    Times times;
    Correctness correctness;   ///< of the empty method: nothing was judged
    bool checksumHeld = true;  ///< every timed run gave the same answers as the verified one
    std::uint32_t layers = 1;  ///< how often a run answered each ray
};

/// One workload and one query: the methods side by side.
struct CellResult {
    Workload workload;
    trace::Query query = trace::Query::Nearest;
    double hitPart = 0.0;  ///< of the rays, measured
    std::size_t rays = 0;  ///< different ones
    std::vector<MethodResult> methods;
};

/// Where, but not when.
struct Machine {
    std::string device;
    std::string driver;      ///< name and version
    std::string deviceType;  ///< "discrete GPU", "CPU", ...
    std::string vulkan;      ///< "1.3.230"
    std::string processor;
    unsigned processors = 0;
    std::string lavapipeThreads;  ///< LP_NUM_THREADS; empty: not set
    std::string clock;            ///< see Stopwatch
};

struct BenchRun {
    Machine machine;
    std::uint64_t seed = 0;
    unsigned rounds = 0;
    std::vector<CellResult> cells;
};

}  // namespace raytorus::bench
