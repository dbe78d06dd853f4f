// SPDX-License-Identifier: MIT
// The results of a verification, for people and for programs.
#pragma once

#include <span>
#include <string>

#include "gpu/context.hpp"
#include "verify/ray_group.hpp"
#include "verify/statistics.hpp"
#include "verify/verifier.hpp"

namespace raytorus::verify {

struct RayGroupResult {
    RayGroup group;
    Statistics statistics;
};

/// What the rows of a table stand for: a class each, and what else keeps groups apart.
enum class Rows { Class, Radius, Distance, Group };

/// A table with a heading; groups that share a row are added up.
std::string tableText(std::span<const RayGroupResult> results, Rows rows);

struct Run {
    std::string method;
    std::string command;  ///< that judges again as this run does; a ray is put behind it
    std::uint64_t seed = 0;
    std::uint64_t raysPerGroup = 0;
    double seconds = 0.0;
    std::string device;
    std::string driver;
};

/// Everything: each group with counts, quantiles, histograms, faults and worst rays (as hexadecimal floats).
std::string resultsJson(const Run& run, std::span<const RayGroupResult> results,
                        std::span<const std::string> exceeded);

/// The command with a ray to replay.
std::string replayCommand(const std::string& command, const reference::Torus& torus,
                          const reference::Ray& ray);

/// One ray, its exact hits and its answers side by side.
std::string replayText(const reference::Torus& torus, const reference::Ray& ray,
                       const Verifier::Replay& replay);

}  // namespace raytorus::verify
