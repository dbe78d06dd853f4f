#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One ray in, one answer out, and nothing else: what --isa has compiled, to count the machine code of a method.

#include "method.glsl"
#include "trace_io.h"

layout(local_size_x = TRACE_GROUP_SIZE) in;
layout(constant_id = TRACE_CONSTANT_QUERY) const int query = TRACE_QUERY_NEAREST;

layout(set = 0, binding = TRACE_BINDING_RAYS, std430) readonly buffer Rays { vec4 rays[]; };
layout(set = 0, binding = TRACE_BINDING_HITS, std430) writeonly buffer Hits { vec4 hits[]; };
layout(push_constant) uniform Query { float majorRadius; float minorRadius; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    vec4 from = rays[2u * i];
    vec4 to = rays[2u * i + 1u];
    Torus torus = Torus(majorRadius, minorRadius);
    if (query == TRACE_QUERY_NEAREST) {
        TorusHit hit;
        bool found = RAY_INTERSECT(torus, from.xyz, from.w, to.xyz, to.w, hit);
        hits[i] = vec4(hit.position, found ? hit.t : -1.0);
    } else if (query == TRACE_QUERY_ALL) {
        TorusHit all[4];
        float count = float(RAY_INTERSECT_ALL(torus, from.xyz, from.w, to.xyz, to.w, all));
        hits[5u * i] = vec4(count);
        for (uint k = 0u; k < 4u; ++k) {
            hits[5u * i + 1u + k] = vec4(all[k].position, all[k].t);
        }
    } else {
        hits[i] = vec4(RAY_OCCLUDED(torus, from.xyz, from.w, to.xyz, to.w) ? 1.0 : 0.0);
    }
}
