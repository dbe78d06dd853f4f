// SPDX-License-Identifier: MIT
// What is timed: rays of one pattern at one shape of torus, from one distance, with one part of hits.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reference/torus_reference.hpp"
#include "trace/tracer.hpp"

namespace raytorus::bench {

/// Tiles: a camera's pixels, neighbours beside each other. Scattered: every ray from elsewhere to elsewhere.
enum class Pattern { Tiles, Scattered };

/// Made: the rays are made in the kernel, 64 an invocation, and the answers added up. Streamed: one ray an
/// invocation, read from a buffer, the answer written to another, by trace.comp.
enum class Mode { Made, Streamed };

struct Workload {
    Mode mode = Mode::Made;
    Pattern pattern = Pattern::Tiles;
    float minorRadius = 0.25F;  ///< the major radius is 1
    double distance = 3.0;      ///< of the camera, or of the rays' origins, from the centre, in R
    int hitPercent = 30;        ///< of the rays that are to hit

    [[nodiscard]] reference::Torus torus() const { return {1.0F, minorRadius}; }
    /// "tiles/0.25/near/30", "stream-scattered/0.25/near/30".
    [[nodiscard]] std::string name() const;
};

/// "nearest", "any", "all".
std::string nameOf(trace::Query query);
inline constexpr trace::Query allQueries[] = {trace::Query::Nearest, trace::Query::Any, trace::Query::All};

/// Tiles and scattered rays; r/R of .01 .1 .25 .5 .9; near (3 R) and far (1000 R); 5, 30, 50 and 80 % hits.
/// And a streamed one of each pattern.
std::vector<Workload> allWorkloads();

/// Those of all that --quick keeps: r/R of .1 and .5, near, 30 and 50 %, and the streamed ones.
bool isQuick(const Workload& workload);

/// Whether a name fits one of the patterns, in which * stands for any characters; no pattern fits every name.
bool fits(const std::string& name, std::span<const std::string> patterns);

}  // namespace raytorus::bench
