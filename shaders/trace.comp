#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out: one torus, one query, a ray an invocation.

#include "method.glsl"
#include "trace_io.h"

layout(local_size_x = TRACE_GROUP_SIZE) in;
layout(constant_id = TRACE_CONSTANT_QUERY) const int query = TRACE_QUERY_NEAREST;

layout(set = 0, binding = TRACE_BINDING_RAYS, std430) readonly buffer Rays { float rays[]; };
layout(set = 0, binding = TRACE_BINDING_HITS, std430) writeonly buffer Hits { float hits[]; };
layout(push_constant) uniform Query { float majorRadius; float minorRadius; uint count; };

void store(uint at, vec3 v) {
    hits[at] = v.x;
    hits[at + 1u] = v.y;
    hits[at + 2u] = v.z;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    uint ray = i * uint(TRACE_RAY_FLOATS);
    vec3 origin = vec3(rays[ray], rays[ray + 1u], rays[ray + 2u]);
    vec3 direction = vec3(rays[ray + 4u], rays[ray + 5u], rays[ray + 6u]);
    float tMin = rays[ray + 3u];
    float tMax = rays[ray + 7u];
    Torus torus = Torus(majorRadius, minorRadius);
    if (query == TRACE_QUERY_NEAREST) {
        TorusHit hit;
        bool found = RAY_INTERSECT(torus, origin, tMin, direction, tMax, hit);
        uint at = i * uint(TRACE_NEAREST_FLOATS);
        hits[at] = found ? 1.0 : 0.0;
        hits[at + 1u] = hit.t;
        store(at + 2u, hit.position);
        store(at + 5u, found ? torusNormal(torus, hit.position) : vec3(0.0));
    } else if (query == TRACE_QUERY_ALL) {
        TorusHit all[4];
        uint at = i * uint(TRACE_ALL_FLOATS);
        hits[at] = float(RAY_INTERSECT_ALL(torus, origin, tMin, direction, tMax, all));
        for (uint k = 0u; k < 4u; ++k) {
            hits[at + 1u + k] = all[k].t;
            store(at + 5u + 3u * k, all[k].position);
        }
    } else {
        hits[i] = RAY_OCCLUDED(torus, origin, tMin, direction, tMax) ? 1.0 : 0.0;
    }
}
