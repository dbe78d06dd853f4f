#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The surface functions of the library, point by point: 8 floats in (R, r, x, y, z, u, v, -), 20 floats out.

#define TORUS_VERSION_REQUIRED 100
#include "torus/torus.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Points { float points[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Answers { float answers[]; };
layout(push_constant) uniform Query { uint count; };

void store(uint at, vec3 v) {
    answers[at] = v.x;
    answers[at + 1u] = v.y;
    answers[at + 2u] = v.z;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    uint from = i * 8u;
    uint to = i * 20u;
    Torus torus = Torus(points[from], points[from + 1u]);
    vec3 point = vec3(points[from + 2u], points[from + 3u], points[from + 4u]);
    vec2 uv = vec2(points[from + 5u], points[from + 6u]);
    vec3 dPdu;
    vec3 dPdv;
    torusTangents(torus, point, dPdu, dPdv);
    vec2 pointUv = torusUv(torus, point);
    store(to, torusNormal(torus, point));
    answers[to + 3u] = pointUv.x;
    answers[to + 4u] = pointUv.y;
    store(to + 5u, torusPosition(torus, uv));
    store(to + 8u, dPdu);
    store(to + 11u, dPdv);
    answers[to + 14u] = torusDistance(torus, point);
    answers[to + 15u] = torusImplicit(torus, point);
    for (uint k = 16u; k < 20u; ++k) {
        answers[to + k] = 0.0;
    }
}
