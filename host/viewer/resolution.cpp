// SPDX-License-Identifier: MIT
#include "viewer/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raytorus::viewer {

void Resolution::learn(VkExtent2D extent, int samples, double seconds) {
    const double pixels = static_cast<double>(extent.width) * extent.height * samples;
    if (pixels <= 0.0) {
        return;
    }
    const double cost = std::max(seconds - secondsPerDrawing, 0.0) / pixels;
    // Cheaper is believed at once in part, dearer slowly: a drawing now and then takes longer for other
    // reasons (a pipeline is compiled, another program runs).
    const double trust = secondsPerPixel == 0.0 ? 1.0 : cost > secondsPerPixel ? 0.2 : 0.5;
    secondsPerPixel += trust * (cost - secondsPerPixel);
}

void Resolution::learnShowing(double seconds) {
    constexpr double trust = 0.2;
    secondsToShow += trust * (std::clamp(seconds, 0.0, 0.1) - secondsToShow);
}

VkExtent2D Resolution::movingExtent(VkExtent2D window) const {
    const double budget = std::clamp(frameSeconds - secondsToShow, leastSeconds, movingSeconds);
    const double pixels = static_cast<double>(window.width) * window.height;
    const double all = secondsPerPixel * pixels;
    if (all <= budget) {
        return window;
    }
    const double scale = std::max(std::sqrt(budget / all), 0.125);
    const auto side = [scale](std::uint32_t full) {
        const auto wanted = static_cast<std::uint32_t>(scale * full) / 8 * 8;
        return std::clamp(wanted, std::min(8U, full), full);
    };
    return {side(window.width), side(window.height)};
}

}  // namespace raytorus::viewer
