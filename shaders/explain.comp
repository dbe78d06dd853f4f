#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One ray in, everything that the library and the closed form make of it out.
#include "explain.glsl"

layout(local_size_x = 1) in;

layout(set = 0, binding = EXPLAIN_BINDING_QUESTION, std430) readonly buffer Question { ExplainQuestion question; };
layout(set = 0, binding = EXPLAIN_BINDING_ANSWER, std430) buffer Answer { ExplainAnswer answer; };

void main() {
    Torus torus = Torus(question.majorRadius, question.minorRadius);
    vec3 origin = vec3(question.origin[0], question.origin[1], question.origin[2]);
    vec3 direction = vec3(question.direction[0], question.direction[1], question.direction[2]);
    // The host hands the answer over filled with zeros.
    ExplainAnswer filled = answer;
    explainHits(torus, origin, question.tMin, direction, question.tMax, filled);
    explainClosedForm(torus, origin, direction, filled);
    answer = filled;
}
