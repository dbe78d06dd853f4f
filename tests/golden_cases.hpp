// SPDX-License-Identifier: MIT
// The table of golden pictures: a row a case, each rendered by both routes and compared with
// golden/<name>.exr.
#pragma once

#include <array>

namespace raytorus::test {

/// Small, so that the folder stays small; the scenes' own shape, 3 : 2.
inline constexpr int goldenWidth = 96;
inline constexpr int goldenHeight = 64;

struct GoldenCase {
    const char* name;     ///< of the scene, scenes/<name>.json, and of the golden
    const char* catches;  ///< what it is there to catch
    /// How far any channel may be off, and in how many pixels more than that, on devices that do not round /
    /// and sqrt correctly; Vulkan allows 2.5 and some 3 ulp. On CPU drivers, which do, every case is exact to
    /// the last bit: the shaders are made of + - * / sqrt and are `precise` throughout.
    double gpuTolerance;
    int gpuAllowedPixels;
    const char* reason;  ///< for the last two
};

inline constexpr std::array goldenCases = {
    GoldenCase{"ring", "checker by uv, two lights, self-shadow", 1e-4, 60,
               "checker edges and the shadow's edge cross about one pixel in a hundred"},
    GoldenCase{"chain", "hierarchy, placement, shadows between links", 1e-4, 180,
               "72 links have some 180 pixels of silhouette and shadow edge"},
    GoldenCase{"thin", "tubes thinner than a pixel, down to r/R = 0.01", 1e-4, 180,
               "half of the pixels that a thin ring touches are silhouette"},
    GoldenCase{"far", "camera at 1000 R: the compensated shift of the origin", 2e-3, 30,
               "t is about 1000, one ulp of it 6e-5"},
    GoldenCase{"inside", "start inside the solid, point light, checker from within", 1e-4, 120,
               "a checker fills the picture"},
    GoldenCase{"nested", "rings within rings, shadows", 1e-4, 120,
               "silhouettes and shadow edges of eight rings"},
    GoldenCase{"spindle", "ring, horn and spindle: the outer sheet alone", 1e-4, 60,
               "silhouettes of three solids"},
};

}  // namespace raytorus::test
