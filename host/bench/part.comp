#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A part of the library between the same numbers in and out: what its instructions are counted by. The part that is none
// writes what it reads.

#include "groups_io.h"
#include "torus/torus.glsl"
#include "trace_io.h"

layout(local_size_x = TRACE_GROUP_SIZE) in;
layout(constant_id = GROUPS_CONSTANT_PART) const int part = GROUPS_PART_NONE;

layout(set = 0, binding = TRACE_BINDING_RAYS, std430) readonly buffer In { vec4 numbers[]; };
layout(set = 0, binding = TRACE_BINDING_HITS, std430) writeonly buffer Out { vec4 results[]; };
layout(push_constant) uniform Query { float majorRadius; float minorRadius; };

void main() {
    uint i = 8u * gl_GlobalInvocationID.x;
    vec4 a = numbers[i];
    vec4 b = numbers[i + 1u];
    vec4 c = numbers[i + 2u];
    vec4 d = numbers[i + 3u];
    vec4 e = numbers[i + 4u];
    bool flag = floatBitsToUint(a.w) != 0u;
    torus_Line line = torus_Line(true, majorRadius, minorRadius, a.xyz, b.xyz, b.w, c.x, d.xyz, d.w, c.y, e.xyz, e.w, c.z,
                                 c.w, a.x, a.y, flag, a.z, b.x, b.y, b.z);
    torus_Quartic quartic = torus_Quartic(a.x, a.y, a.z, b.x, b.y, b.z, b.w, minorRadius);
    torus_March march = torus_March(c.x, c.y, c.z, c.w, true, flag, flag, flag, d.x, d.y);
    if (part == GROUPS_PART_ENDS) {
        line = torus_reduce(majorRadius, minorRadius, a.xyz, a.w, b.xyz, b.w);
        bool left = torus_clip(line, a.w, b.w);
        quartic = torus_quartic(line);
        march = torus_startMarch(line, quartic);
        TorusHit hit = torus_hitAt(line, torus_Crossing(left, c.xyz, c.w, d.x), a.w, b.w);
        results[i] = vec4(hit.position, hit.t);
        results[i + 1u] = vec4(march.u, march.side, march.reach, left ? quartic.blur : 0.0);
        results[i + 2u] = vec4(quartic.k, quartic.b0, quartic.b1, quartic.edge2);
    } else if (part == GROUPS_PART_STEP) {
        torus_search(quartic, d.z, 1, march);
        results[i] = vec4(march.u, march.reach, march.refines ? 1.0 : 0.0, march.searching ? 1.0 : 0.0);
        results[i + 1u] = vec4(march.known ? 1.0 : 0.0);
        results[i + 2u] = vec4(march.side);
    } else if (part == GROUPS_PART_REFINEMENT) {
        torus_Crossing crossing = torus_refine(line, march);
        results[i] = vec4(crossing.position, crossing.found ? 1.0 : 0.0);
        results[i + 1u] = vec4(crossing.shift, crossing.rest, march.u, march.side);
        results[i + 2u] = vec4(march.reach, march.refines ? 1.0 : 0.0, march.f, march.h);
    } else {
        results[i] = a + e;
        results[i + 1u] = b + d;
        results[i + 2u] = c;
    }
}
