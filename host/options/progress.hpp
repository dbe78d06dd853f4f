// SPDX-License-Identifier: MIT
// A progress bar on standard error, if that is a terminal and the work takes long enough for one to be
// wanted.
#pragma once

#include <chrono>
#include <string>

namespace raytorus::options {

class Progress {
public:
    /// `label` stands before the bar.
    explicit Progress(std::string label);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Clears the bar.
    ~Progress();

    /// The part done, 0 to 1.
    void show(double done);

private:
    std::string label;
    bool terminal;
    bool shown = false;
    std::chrono::steady_clock::time_point start;
    std::chrono::steady_clock::time_point last;
};

}  // namespace raytorus::options
