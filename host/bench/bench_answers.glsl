// SPDX-License-Identifier: MIT
// One ray answered, and its answer added up, or written. The sum takes every bit of every output, so nothing of what
// a method computes can be left out.
#ifndef BENCH_ANSWERS_GLSL
#define BENCH_ANSWERS_GLSL

#include "bench_rays.glsl"
#include "trace_io.h"

layout(constant_id = BENCH_CONSTANT_QUERY) const int query = TRACE_QUERY_NEAREST;
layout(set = 0, binding = BENCH_BINDING_WORDS, std430) writeonly buffer Words { uint words[]; };

uint benchPut(bool write, uint at, float value) {
    uint bits = floatBitsToUint(value);
    if (write) {
        words[at] = bits;
    }
    return bits;
}

uint benchPutHit(bool write, uint at, uint stride, TorusHit hit) {
    return benchPut(write, at, hit.t) + benchPut(write, at + stride, hit.position.x) +
           benchPut(write, at + stride + 1u, hit.position.y) + benchPut(write, at + stride + 2u, hit.position.z);
}

void benchWriteRay(uint index, BenchRay ray, float rayEnd) {
    uint at = index * uint(TRACE_RAY_FLOATS);
    float values[TRACE_RAY_FLOATS] = float[](ray.origin.x, ray.origin.y, ray.origin.z, 0.0, ray.direction.x,
                                             ray.direction.y, ray.direction.z, rayEnd);
    for (int i = 0; i < TRACE_RAY_FLOATS; ++i) {
        words[at + uint(i)] = floatBitsToUint(values[i]);
    }
}

// The sum of the bits of the answer to ray `index`; the answer itself is stored if `write`.
uint benchAnswer(Torus torus, BenchRay ray, float rayEnd, bool write, uint index) {
    if (query == TRACE_QUERY_NEAREST) {
        TorusHit hit;
        uint at = index * uint(BENCH_NEAREST_FLOATS);
        bool found = RAY_INTERSECT(torus, ray.origin, 0.0, ray.direction, rayEnd, hit);
        return benchPut(write, at, found ? 1.0 : 0.0) + benchPutHit(write, at + 1u, 1u, hit);
    }
    if (query == TRACE_QUERY_ALL) {
        TorusHit all[4];
        uint at = index * uint(TRACE_ALL_FLOATS);
        int count = RAY_INTERSECT_ALL(torus, ray.origin, 0.0, ray.direction, rayEnd, all);
        uint sum = benchPut(write, at, float(count));
        for (uint i = 0u; i < 4u; ++i) {
            sum += benchPutHit(write, at + 1u + i, 4u + 2u * i, all[i]);
        }
        return sum;
    }
    bool hit = RAY_OCCLUDED(torus, ray.origin, 0.0, ray.direction, rayEnd);
    return benchPut(write, index, hit ? 1.0 : 0.0);
}

#endif
