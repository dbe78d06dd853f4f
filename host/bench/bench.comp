#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// 64 rays an invocation, made here, through one method: see bench_io.h.

#include "method.glsl"
#include "bench_rays.glsl"
#include "bench_answers.glsl"

layout(local_size_x = BENCH_TILE_SIDE, local_size_y = BENCH_TILE_SIDE) in;
layout(constant_id = BENCH_CONSTANT_SCATTERED) const bool scattered = false;
layout(constant_id = BENCH_CONSTANT_TASK) const int task = BENCH_TASK_TIME;

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint invocation = group * uint(BENCH_GROUP_SIZE) + gl_LocalInvocationIndex;
    uvec2 block = gl_WorkGroupID.xy * uint(BENCH_BLOCK_SIDE) + gl_LocalInvocationID.xy;
    uvec4 state = benchStart(invocation);
    uint sum = 0u;
    for (uint k = 0u; k < uint(BENCH_RAYS_EACH); ++k) {
        float zero = benchNothing(k);
        BenchRay ray;
        if (scattered) {
            benchStep(state);
            ray = benchScatteredRay(state);
        } else {
            uvec2 tile = uvec2(k % uint(BENCH_TILES_A_SIDE), k / uint(BENCH_TILES_A_SIDE));
            ray = benchTileRay(block + tile * uint(BENCH_TILE_SIDE), zero);
        }
        uint index = (group * uint(BENCH_RAYS_EACH) + k) * uint(BENCH_GROUP_SIZE) + gl_LocalInvocationIndex;
        if (task == BENCH_TASK_RAYS) {
            benchWriteRay(index, ray, tMax);
        } else {
            Torus torus = Torus(majorRadius + zero, minorRadius + zero);
            sum += benchAnswer(torus, ray, tMax, task == BENCH_TASK_ANSWERS, index);
        }
    }
    if (task == BENCH_TASK_TIME) {
        uint invocations = gl_NumWorkGroups.x * gl_NumWorkGroups.y * uint(BENCH_GROUP_SIZE);
        words[gl_WorkGroupID.z * invocations + invocation] = sum;
    }
}
