// SPDX-License-Identifier: MIT
// The surface functions of the library, asked of the device point by point through probe.comp.
#pragma once

#include <vector>

namespace raytorus::test {

/// What the functions are asked about, as probe.comp reads it.
struct SurfacePoint {
    float majorRadius;
    float minorRadius;
    float point[3];
    float uv[2];
    float unused = 0.0F;
};

/// Every function's answer: torusPosition is asked about uv, the others about the point.
struct SurfaceAnswer {
    float normal[3];
    float uv[2];
    float position[3];
    float dPdu[3];
    float dPdv[3];
    float distance;
    float implicit;
    float unused[4];
};

std::vector<SurfaceAnswer> probe(const std::vector<SurfacePoint>& points);

}  // namespace raytorus::test
