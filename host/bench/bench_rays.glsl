// SPDX-License-Identifier: MIT
// The rays of a workload, made where they are needed: read from a buffer, 64 rays an invocation would measure the
// buffer. `precise`, and from + - * / sqrt and whole numbers alone: every pipeline makes the same bits of them, so the
// rays that are verified are those that are timed.
#ifndef BENCH_RAYS_GLSL
#define BENCH_RAYS_GLSL

#include "bench_io.h"

layout(push_constant) uniform BenchView {
    vec3 origin;         // tiles: the camera ...
    float majorRadius;
    vec3 corner;         // ... the direction of its first pixel ...
    float minorRadius;
    vec3 right;          // ... and from a pixel to the next
    float tMax;
    vec3 up;
    float startDistance;    // scattered: of the origins from the centre ...
    float spread;        // ... and how far from the ring they aim
    uint seed;
    uint nothing;        // 0, which no compiler knows: see benchNothing
};

struct BenchRay {
    vec3 origin;
    vec3 direction;
};

// PCG's output function (O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms, Harvey
// Mudd College, 2014): one number to start each invocation's sequences with.
uint benchHash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

uvec4 benchStart(uint invocation) {
    uint a = benchHash(invocation ^ seed);
    uint b = benchHash(a);
    uint c = benchHash(b);
    return uvec4(a, b, c, benchHash(c));
}

// The additive sequence of four dimensions that fills them evenly: steps of 1/g, 1/g^2, 1/g^3, 1/g^4, g^5 = g + 1
// (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018), in 2^-32, odd.
void benchStep(inout uvec4 state) {
    state += uvec4(3679390609u, 3152041523u, 2700274805u, 2313257605u);
}

// In (-1, 1), never 0, exact: from 16 bits.
float benchSigned(uint bits16) {
    return float(2u * bits16 + 1u) * 1.52587890625e-5 - 1.0;
}

vec3 benchHigh(uvec4 state) {
    return vec3(benchSigned(state.x >> 16), benchSigned(state.y >> 16), benchSigned(state.z >> 16));
}

vec3 benchLow(uvec4 state) {
    return vec3(benchSigned(state.x & 0xffffu), benchSigned(state.y & 0xffffu), benchSigned(state.z & 0xffffu));
}

// 0, but to a compiler another number in each turn of the loop: added to what all turns share, it keeps what a method
// computes of that alone inside the loop, as it is where an invocation has one ray.
float benchNothing(uint turn) {
    return float(turn & nothing);
}

// Pixel x, y of the camera.
BenchRay benchTileRay(uvec2 pixel, float zero) {
    float x = float(pixel.x);
    float y = float(pixel.y);
    precise vec3 direction = corner + x * right + y * up;
    precise vec3 start = origin + zero;
    return BenchRay(start, direction);
}

// From anywhere on a sphere, past a point of the ring at up to `spread` in each coordinate, and by as much pulled
// back: with a large spread the rays go away, so every part of hits can be had, and with a small one it turns no ray.
BenchRay benchScatteredRay(uvec4 state) {
    vec3 cube = benchHigh(state);
    precise float square = cube.x * cube.x + cube.y * cube.y + cube.z * cube.z;
    precise float perLength = 1.0 / sqrt(square);
    precise vec3 away = cube * perLength;
    // A point of the circle, by its rational parametrisation of the half with x > 0, and a bit for the other half.
    float q = benchSigned(state.w >> 16);
    precise float perSum = 1.0 / (1.0 + q * q);
    precise float ringX = (1.0 - q * q) * perSum * majorRadius;
    precise float ringY = 2.0 * q * perSum * majorRadius;
    ringX = (state.w & 0x8000u) == 0u ? ringX : -ringX;
    precise vec3 start = away * startDistance;
    precise vec3 aim = vec3(ringX, ringY, 0.0) + spread * (benchLow(state) + away);
    precise vec3 direction = aim - start;
    return BenchRay(start, direction);
}

#endif
