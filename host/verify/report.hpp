// SPDX-License-Identifier: MIT
// The results of a verification, for people and for programs.
#pragma once

#include <span>
#include <string>

#include "gpu/context.hpp"
#include "verify/cell.hpp"

namespace raytorus::verify {

struct CellResult {
    Cell cell;
    Statistics statistics;
};

/// What the rows of a table stand for: a class each, and what else keeps cells apart.
enum class Rows { Class, Radius, Distance, Cell };

/// A table with a heading; cells that share a row are added up.
std::string tableText(std::span<const CellResult> results, Rows rows);

struct Run {
    std::string method;
    std::string command;  ///< that judges again as this run does; a ray is put behind it
    std::uint64_t seed = 0;
    std::uint64_t raysPerCell = 0;
    double seconds = 0.0;
    std::string device;
    std::string driver;
};

/// Everything: each cell with counts, quantiles, histograms, faults and worst rays (as hexadecimal floats).
std::string resultsJson(const Run& run, std::span<const CellResult> results,
                        std::span<const std::string> broken);

/// The command with a ray to replay.
std::string replayCommand(const std::string& command, const reference::Torus& torus,
                          const reference::Ray& ray);

}  // namespace raytorus::verify
