// SPDX-License-Identifier: MIT
// The results for programs, and for a later run to compare itself with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/result.hpp"

namespace raytorus::bench {

/// A line a method, numbers to four digits, so that tables in a repository differ in lines:
///
///     {"format": "raytorus-bench", "version": 1, "machine": {...}, "seed": 1, "rounds": 9, "cells": [
///      {"workload": "tiles/0.25/near/30", "query": "nearest", "hitPart": 0.3, "rays": 65536, "methods": {
///       "raytorus": {"min": 21.3, "median": 21.4, "net": 20.5, "ratio": 1, "quartiles": [1, 1, 1],
///                    "judged": 65499, "wrong": 0, "gross": 0, "p99": 4.8e-08, "layers": 3,
///                    "checksumHeld": true},
///       ...
///
/// Times in ns a ray; "ratio" and "quartiles" (lower, median, upper): ours over its; 0 where there is none.
std::string runJson(const BenchRun& run);

/// What --against needs of an earlier table.
struct ReferenceRow {
    std::string workload;
    std::string query;
    std::string method;
    double ratio = 0.0;
    double lowerQuartile = 0.0;
    double upperQuartile = 0.0;
    std::size_t wrong = 0;  ///< with gross ones
    std::size_t rays = 0;
};

struct ReferenceTable {
    std::string file;
    std::string device;
    std::string driver;
    std::string lavapipeThreads;
    std::vector<ReferenceRow> rows;
};

/// Reads what runJson wrote. Throws Error{File}: missing or unreadable, no JSON, another format or version,
/// or something missing in it.
ReferenceTable readReference(const std::filesystem::path& path);

}  // namespace raytorus::bench
