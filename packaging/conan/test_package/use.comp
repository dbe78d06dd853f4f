#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#include "torus.glsl"

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std430) writeonly buffer Depth { float depth; };

void main() {
    TorusHit hit;
    bool found = torusIntersect(Torus(1.0, 0.25), vec3(3.0, 0.0, 0.0), 0.0, vec3(-1.0, 0.0, 0.0), 9.0, hit);
    depth = found ? hit.t : -1.0;
}
