// SPDX-License-Identifier: MIT
// The sizes of tori that the library answers for (torus.glsl): beyond them it finds no hit.
#pragma once

namespace raytorus {

inline constexpr double smallestTorus = 1e-18;  ///< R + r, in the caller's unit
inline constexpr double largestTorus = 1e18;

constexpr bool isTorusInRange(double majorRadius, double minorRadius) {
    const double size = majorRadius + minorRadius;
    return size >= smallestTorus && size <= largestTorus;
}

}  // namespace raytorus
