#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// How far away is the torus? One ray an invocation, downwards from a plane above it; -1 where there is none.
#define TORUS_VERSION_REQUIRED 100
#include "torus.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) writeonly buffer Depths { float depths[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    vec3 origin = vec3(0.01 * float(i), 0.0, 2.0);
    TorusHit hit;
    bool found = torusIntersect(Torus(1.0, 0.25), origin, 0.0, vec3(0.0, 0.0, -1.0), 100.0, hit);
    depths[i] = found ? hit.t : -1.0;
}
