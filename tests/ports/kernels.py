# SPDX-License-Identifier: MIT
"""Shaders that answer rays in rows of 26 floats, in the languages that the proof runs."""
from __future__ import annotations

GLSL_ROW = """
void answer(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out float row[28]) {
    TorusHit hit;
    TorusHit hits[4];
    bool found = torusIntersect(torus, origin, tMin, direction, tMax, hit);
    vec3 normal = found ? torusNormal(torus, hit.position) : vec3(0.0);
    row[0] = found ? 1.0 : 0.0;
    row[1] = hit.t;
    row[2] = hit.position.x;
    row[3] = hit.position.y;
    row[4] = hit.position.z;
    row[5] = normal.x;
    row[6] = normal.y;
    row[7] = normal.z;
    row[8] = float(torusIntersectAll(torus, origin, tMin, direction, tMax, hits));
    for (int k = 0; k < 4; ++k) {
        row[9 + k] = hits[k].t;
        row[13 + 3 * k] = hits[k].position.x;
        row[14 + 3 * k] = hits[k].position.y;
        row[15 + 3 * k] = hits[k].position.z;
    }
    row[25] = torusOccluded(torus, origin, tMin, direction, tMax) ? 1.0 : 0.0;
    row[26] = 0.0;
    row[27] = 0.0;
}
"""

GLSL_COMPUTE = GLSL_ROW + """
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Rays { float rays[]; };
layout(std430, binding = 1) buffer Rows { float rows[]; };
layout(std430, binding = 2) readonly buffer Radii { float radii[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    uint ray = i * 8u;
    if (ray >= uint(rays.length())) {
        return;
    }
    float row[28];
    answer(Torus(radii[0], radii[1]), vec3(rays[ray], rays[ray + 1u], rays[ray + 2u]), rays[ray + 3u],
           vec3(rays[ray + 4u], rays[ray + 5u], rays[ray + 6u]), rays[ray + 7u], row);
    for (uint k = 0u; k < 26u; ++k) {
        rows[26u * i + k] = row[k];
    }
}
"""

# A ray a pixel: two texels of a texture in, seven targets out.
GLSL_FRAGMENT = GLSL_ROW + """
uniform highp sampler2D rays;
uniform vec2 radii;
""" + "".join(f"layout(location = {i}) out vec4 out{i};\n" for i in range(7)) + """
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 first = texelFetch(rays, ivec2(2 * pixel.x, pixel.y), 0);
    vec4 second = texelFetch(rays, ivec2(2 * pixel.x + 1, pixel.y), 0);
    float row[28];
    answer(Torus(radii.x, radii.y), vec3(first.x, first.y, first.z), first.w, vec3(second.x, second.y, second.z), second.w,
           row);
""" + "".join(f"    out{i} = vec4(row[{4 * i}], row[{4 * i + 1}], row[{4 * i + 2}], row[{4 * i + 3}]);\n" for i in range(7)) + "}\n"

GLSL_VERTEX = """
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
"""

WGSL_COMPUTE = """
@group(0) @binding(0) var<storage, read> rays: array<f32>;
@group(0) @binding(1) var<storage, read_write> rows: array<f32>;
@group(0) @binding(2) var<storage, read> radii: array<f32>;

fn store(at: u32, v: vec3<f32>) {
    rows[at] = v.x;
    rows[at + 1u] = v.y;
    rows[at + 2u] = v.z;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let ray = id.x * 8u;
    if (ray >= arrayLength(&rays)) {
        return;
    }
    let torus = Torus(radii[0], radii[1]);
    let origin = vec3<f32>(rays[ray], rays[ray + 1u], rays[ray + 2u]);
    let direction = vec3<f32>(rays[ray + 4u], rays[ray + 5u], rays[ray + 6u]);
    let tMin = rays[ray + 3u];
    let tMax = rays[ray + 7u];
    let at = id.x * 26u;
    var hit: TorusHit;
    let found = torusIntersect(torus, origin, tMin, direction, tMax, &hit);
    rows[at] = select(0.0, 1.0, found);
    rows[at + 1u] = hit.t;
    store(at + 2u, hit.position);
    store(at + 5u, select(vec3<f32>(0.0), torusNormal(torus, hit.position), found));
    var hits: array<TorusHit, 4>;
    rows[at + 8u] = f32(torusIntersectAll(torus, origin, tMin, direction, tMax, &hits));
    for (var k = 0u; k < 4u; k++) {
        rows[at + 9u + k] = hits[k].t;
        store(at + 13u + 3u * k, hits[k].position);
    }
    rows[at + 25u] = select(0.0, 1.0, torusOccluded(torus, origin, tMin, direction, tMax));
}
"""

CXX_PROGRAM = """
#include <cstdio>
#include <cstdlib>
#include "raytorus.hpp"
using namespace raytorus_cxx;

static void put(float* to, vec3 v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

// R r < rays > rows
int main(int, char** argv) {
    const Torus torus{std::strtof(argv[1], nullptr), std::strtof(argv[2], nullptr)};
    float ray[8];
    while (std::fread(ray, sizeof ray, 1, stdin) == 1) {
        const vec3 origin(ray[0], ray[1], ray[2]);
        const vec3 direction(ray[4], ray[5], ray[6]);
        float row[26] = {};
        TorusHit hit;
        TorusHit hits[4];
        const bool found = torusIntersect(torus, origin, ray[3], direction, ray[7], hit);
        row[0] = found ? 1.0F : 0.0F;
        row[1] = hit.t;
        put(row + 2, hit.position);
        put(row + 5, found ? torusNormal(torus, hit.position) : vec3(0.0F, 0.0F, 0.0F));
        row[8] = static_cast<float>(torusIntersectAll(torus, origin, ray[3], direction, ray[7], hits));
        for (int k = 0; k < 4; ++k) {
            row[9 + k] = hits[k].t;
            put(row + 13 + 3 * k, hits[k].position);
        }
        row[25] = torusOccluded(torus, origin, ray[3], direction, ray[7]) ? 1.0F : 0.0F;
        std::fwrite(row, sizeof row, 1, stdout);
    }
}
"""

# As shaders/trace.comp: for `raytorus trace --shaders`.
GLSL_TRACE = """
layout(local_size_x = 64) in;
layout(constant_id = 0) const int query = 0;
layout(set = 0, binding = 0, std430) readonly buffer Rays { float rays[]; };
layout(set = 0, binding = 1, std430) buffer Hits { float hits[]; };
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
    uint ray = 8u * i;
    vec3 origin = vec3(rays[ray], rays[ray + 1u], rays[ray + 2u]);
    vec3 direction = vec3(rays[ray + 4u], rays[ray + 5u], rays[ray + 6u]);
    float tMin = rays[ray + 3u];
    float tMax = rays[ray + 7u];
    Torus torus = Torus(majorRadius, minorRadius);
    if (query == 0) {
        TorusHit hit;
        bool found = torusIntersect(torus, origin, tMin, direction, tMax, hit);
        hits[8u * i] = found ? 1.0 : 0.0;
        hits[8u * i + 1u] = hit.t;
        store(8u * i + 2u, hit.position);
        store(8u * i + 5u, found ? torusNormal(torus, hit.position) : vec3(0.0, 0.0, 0.0));
    } else if (query == 1) {
        TorusHit all[4];
        hits[17u * i] = float(torusIntersectAll(torus, origin, tMin, direction, tMax, all));
        for (uint k = 0u; k < 4u; ++k) {
            hits[17u * i + 1u + k] = all[k].t;
            store(17u * i + 5u + 3u * k, all[k].position);
        }
    } else {
        hits[i] = torusOccluded(torus, origin, tMin, direction, tMax) ? 1.0 : 0.0;
    }
}
"""

# The pasted function knows the nearest hit alone.
FAST_FUNCTION_TRACE = """
layout(local_size_x = 64) in;
layout(constant_id = 0) const int query = 0;
layout(set = 0, binding = 0, std430) readonly buffer Rays { float rays[]; };
layout(set = 0, binding = 1, std430) buffer Hits { float hits[]; };
layout(push_constant) uniform Query { float majorRadius; float minorRadius; uint count; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count || query != 0) {
        return;
    }
    uint ray = 8u * i;
    vec3 origin = vec3(rays[ray], rays[ray + 1u], rays[ray + 2u]);
    vec3 direction = vec3(rays[ray + 4u], rays[ray + 5u], rays[ray + 6u]);
    float t;
    vec3 position;
    vec3 normal;
    bool found = raytorusFast(majorRadius, minorRadius, origin, rays[ray + 3u], direction, rays[ray + 7u], t, position, normal);
    hits[ray] = found ? 1.0 : 0.0;
    hits[ray + 1u] = t;
    for (int k = 0; k < 3; ++k) {
        hits[ray + 2u + uint(k)] = position[k];
        hits[ray + 5u + uint(k)] = found ? normal[k] : 0.0;
    }
}
"""

HLSL_TRACE = """
[[vk::binding(0, 0)]] StructuredBuffer<float> rays;
[[vk::binding(1, 0)]] RWStructuredBuffer<float> hits;
struct Query {
    float majorRadius;
    float minorRadius;
    uint count;
};
[[vk::push_constant]] Query asked;
[[vk::constant_id(0)]] const int query = 0;

void store(uint at, float3 v) {
    hits[at] = v.x;
    hits[at + 1] = v.y;
    hits[at + 2] = v.z;
}

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    uint i = id.x;
    if (i >= asked.count) {
        return;
    }
    uint ray = 8 * i;
    float3 origin = float3(rays[ray], rays[ray + 1], rays[ray + 2]);
    float3 direction = float3(rays[ray + 4], rays[ray + 5], rays[ray + 6]);
    float tMin = rays[ray + 3];
    float tMax = rays[ray + 7];
    Torus torus = torus_makeTorus(asked.majorRadius, asked.minorRadius);
    if (query == 0) {
        TorusHit hit;
        bool found = torusIntersect(torus, origin, tMin, direction, tMax, hit);
        float3 normal = float3(0.0, 0.0, 0.0);
        if (found) {
            normal = torusNormal(torus, hit.position);
        }
        hits[8 * i] = found ? 1.0 : 0.0;
        hits[8 * i + 1] = hit.t;
        store(8 * i + 2, hit.position);
        store(8 * i + 5, normal);
    } else if (query == 1) {
        TorusHit all[4];
        hits[17 * i] = float(torusIntersectAll(torus, origin, tMin, direction, tMax, all));
        for (uint k = 0; k < 4; ++k) {
            hits[17 * i + 1 + k] = all[k].t;
            store(17 * i + 5 + 3 * k, all[k].position);
        }
    } else {
        hits[i] = torusOccluded(torus, origin, tMin, direction, tMax) ? 1.0 : 0.0;
    }
}
"""
