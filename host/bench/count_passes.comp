#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// What the library does for the nearest hit of each ray: how many steps in which pass, and in which passes a refinement.
// See groups.hpp.

#include "groups_io.h"
#include "trace_io.h"

uint passes = 0u;
uint steps = 0u;
uint stepsOfPasses = 0u;
uint refinements = 0u;
uint refiningPasses = 0u;

void countStep() {
    uint pass = passes - 1u;
    ++steps;
    if (pass < uint(GROUPS_PASSES)) {
        stepsOfPasses += 1u << (GROUPS_BITS_OF_A_PASS * pass);
    }
}

void countRefinement() {
    ++refinements;
    refiningPasses |= 1u << min(passes - 1u, 31u);
}

#define TORUS_ON_PASS ++passes;
#define TORUS_ON_STEP countStep();
#define TORUS_ON_REFINEMENT countRefinement();
#include "torus/torus.glsl"

layout(local_size_x = TRACE_GROUP_SIZE) in;

layout(set = 0, binding = TRACE_BINDING_RAYS, std430) readonly buffer Rays { vec4 rays[]; };
layout(set = 0, binding = TRACE_BINDING_HITS, std430) writeonly buffer Counts { uvec4 counts[]; };
layout(push_constant) uniform Query { float majorRadius; float minorRadius; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    vec4 from = rays[2u * i];
    vec4 to = rays[2u * i + 1u];
    Torus torus = Torus(majorRadius, minorRadius);
    TorusHit hit;
    uint hits = torusIntersect(torus, from.xyz, from.w, to.xyz, to.w, hit) ? 1u : 0u;
    counts[i] = uvec4(steps, stepsOfPasses, refiningPasses, hits | refinements << GROUPS_REFINEMENTS_SHIFT);
}
