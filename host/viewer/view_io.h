// SPDX-License-Identifier: MIT
// What the viewer's host code and view.comp exchange, compiled by both.
#ifndef RAYTORUS_VIEW_IO_H
#define RAYTORUS_VIEW_IO_H

#ifdef __cplusplus
#include <cstdint>
namespace raytorus::view_io {
using uint = std::uint32_t;
#endif

// Pictures of the left side, in the order of ScenePixel in shade.glsl; then those of the right side of a
// wipe.
#define VIEW_BINDING_LEFT 0
#define VIEW_BINDING_RIGHT 4
// What the host has worked out about the left side: see Analysis.
#define VIEW_BINDING_ANALYSIS 8
#define VIEW_BINDING_OUTPUT 9
#define VIEW_BINDING_COUNT 10

#define VIEW_GROUP 8

// The views, by number.
#define VIEW_SHADED 0
#define VIEW_NORMAL 1
#define VIEW_UV 2
#define VIEW_DEPTH 3
#define VIEW_COUNT 4
#define VIEW_TORUS 5
#define VIEW_STEPS 6
#define VIEW_SURFACE 7
#define VIEW_REFERENCE 8
#define VIEW_GOLDEN 9

// x of the analysis: what came of a pixel.
#define ANALYSIS_PENDING 0
#define ANALYSIS_MISS 1  // nothing is hit, and nothing was found
#define ANALYSIS_HIT 2  // y: distance of the hit from the surface, z: from the reference's hit, both in units
#define ANALYSIS_WRONG 3  // hit and miss, the torus or the number of surfaces disagree with the reference
#define ANALYSIS_COLOR 4  // yzw: linear RGB to be shown as it is

// Errors are shown by their logarithm from 0.1 to 1e6 units. What the library promises ends at 1.5: blue to
// there.
#define VIEW_ERROR_DECADES 7.0
#define VIEW_ERROR_SMALLEST 0.1

// Colour ramps as displayed, stop by stop: `make` is vec3 in the shader and what the legend needs on the
// host.
#define VIEW_RAMP_STOPS 5
#define VIEW_RAMP(make)                                                                             \
    make(0.05, 0.06, 0.12), make(0.20, 0.24, 0.60), make(0.13, 0.60, 0.62), make(0.95, 0.80, 0.25), \
        make(1.0, 0.97, 0.9)
// A stop a decade: 0.1, 1, 10, ... 1e6.
#define VIEW_ERROR_STOPS 8
#define VIEW_ERROR_RAMP(make)                                                                       \
    make(0.04, 0.09, 0.25), make(0.18, 0.42, 0.85), make(0.98, 0.85, 0.25), make(0.97, 0.60, 0.15), \
        make(0.90, 0.33, 0.12), make(0.75, 0.12, 0.15), make(0.95, 0.65, 0.65), make(1.0, 1.0, 1.0)

struct ViewPush {
    uint width;  // of the pictures
    uint height;
    uint view;
    uint wipe;      // the first column of the right side; width or more: there is none
    uint linear;    // 1: the window's format encodes sRGB itself
    float nearest;  // of the depth view: the t shown white, and the one shown black
    float farthest;
    float mostSteps;  // of the steps view: shown white
};

#ifdef __cplusplus
}  // namespace raytorus::view_io
#endif

#endif
