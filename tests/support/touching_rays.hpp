// SPDX-License-Identifier: MIT
// Rays that touch a torus exactly, as numbers that floats hold: both hits of a touch are right, and so are
// none.
#pragma once

namespace raytorus::test {

/// As --replay takes them. On the walls of pipes, on both equators from without and within, along the top
/// circle (a fourfold contact beside it), and on a horn's flank.
inline constexpr const char* touchingRays[] = {
    "200 50  250 0 500 0  0 0 -1 inf", "1 0.25  1.25 0 5 0  0 0 -1 inf", "1 0.25  0.75 0 5 0  0 0 -1 inf",
    "1 0.25  -5 1.25 0 0  1 0 0 inf",  "1 0.25  -5 0.75 0 0  1 0 0 inf", "1 0.25  -5 1 0.25 0  1 0 0 inf",
    "1 0.25  -5 0 0.25 0  1 0 0 inf",  "2 1  5 3 0 0  -1 0 0 inf"};

}  // namespace raytorus::test
