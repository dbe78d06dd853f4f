// SPDX-License-Identifier: MIT
#include "options/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace raytorus::options {
namespace {

using std::chrono::steady_clock;

constexpr double quietSeconds = 0.5;  // shorter work shows no bar
constexpr double redrawSeconds = 0.1;
constexpr int barWidth = 32;

double secondsBetween(steady_clock::time_point from, steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Progress::Progress(std::string text)
    : label(std::move(text)), terminal(isatty(STDERR_FILENO) == 1), start(steady_clock::now()), last(start) {}

Progress::~Progress() {
    if (shown) {
        std::fputs("\r\033[K", stderr);
    }
}

void Progress::show(double done) {
    const steady_clock::time_point now = steady_clock::now();
    const double elapsed = secondsBetween(start, now);
    if (!terminal || elapsed < quietSeconds || secondsBetween(last, now) < redrawSeconds) {
        return;
    }
    last = now;
    shown = true;
    const double part = std::clamp(done, 0.0, 1.0);
    const int filled = static_cast<int>(part * barWidth);
    const double left = part > 0.0 ? elapsed * (1.0 - part) / part : 0.0;
    const std::string bar = fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} % {:.0f} s left", label, "",
                                        filled, "", barWidth - filled, 100.0 * part, left);
    std::fputs(bar.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace raytorus::options
