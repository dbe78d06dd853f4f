#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One ray in, everything that the library and the closed form make of it out.
#include "explain.glsl"

layout(local_size_x = 1) in;

layout(set = 0, binding = EXPLAIN_BINDING_QUERY, std430) readonly buffer Query { ExplainQuery query; };
layout(set = 0, binding = EXPLAIN_BINDING_ANSWER, std430) buffer Answer { ExplainAnswer answer; };

void main() {
    Torus torus = Torus(query.majorRadius, query.minorRadius);
    vec3 origin = vec3(query.origin[0], query.origin[1], query.origin[2]);
    vec3 direction = vec3(query.direction[0], query.direction[1], query.direction[2]);
    // The host hands the answer over filled with zeros.
    ExplainAnswer filled = answer;
    explainHits(torus, origin, query.tMin, direction, query.tMax, filled);
    explainClosedForm(torus, origin, direction, filled);
    answer = filled;
}
