#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// What the library finds of the arithmetic here: compiler, driver and device together.
layout(local_size_x = 1) in;

#include "torus/torus.glsl"

layout(set = 0, binding = 0, std430) writeonly buffer Found {
    int found;
};

// 1, which no compiler knows.
layout(push_constant) uniform One {
    float one;
};

void main() {
    found = torusSelfCheck(one);
}
