#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A torus seen from above, coloured by its normal. Draw one triangle that covers the picture.
#include "torus.glsl"

layout(push_constant) uniform Picture { vec2 size; };
layout(location = 0) out vec4 color;

void main() {
    Torus torus = Torus(1.0, 0.4);
    vec3 origin = vec3(0.0, -4.0, 3.0);
    vec2 pixel = (2.0 * gl_FragCoord.xy - size) / size.y;
    vec3 direction = vec3(pixel.x, 2.0 - 0.6 * pixel.y, -1.5 - 0.8 * pixel.y);
    TorusHit hit;
    bool found = torusIntersect(torus, origin, 0.0, direction, 1.0e30, hit);
    color = vec4(found ? 0.5 + 0.5 * torusNormal(torus, hit.position) : vec3(0.1), 1.0);
}
