// SPDX-License-Identifier: MIT
// Which moments of a scene `raytorus render` draws, and into which files.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace raytorus::options {

struct FrameOptions {
    std::string time;   ///< empty: 0
    std::string count;  ///< --frames; empty: one picture
    std::string rate;   ///< --fps

    /// The scene is to be seen in motion.
    [[nodiscard]] bool moves() const { return !time.empty() || !count.empty() || !rate.empty(); }
    [[nodiscard]] bool sequence() const { return !count.empty(); }
};

/// --time, --frames, --fps.
void addFrameOptions(CLI::App& command, FrameOptions& options);

/// One picture of a sequence.
struct SequenceFrame {
    std::string output;
    double seconds = 0.0;
};

/// One frame for `output` itself; or with --frames N those from 0 to N - 1, in whose names the number, with
/// zeros before it, stands for the one run of # in the name of the file. Frame k is the moment --time + k /
/// --fps. Throws Error{Usage} if the options contradict each other or the pattern.
[[nodiscard]] std::vector<SequenceFrame> framesOf(const FrameOptions& options, const std::string& output);

}  // namespace raytorus::options
