#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The closed form, ray by ray: 8 floats in (R, r, origin, direction), 32 floats out, see closed_form_probe.hpp.
#include "torus/closed_form.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Rays { float rays[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Answers { float answers[]; };
layout(push_constant) uniform Query { uint count; };

void storeRoots(uint at, int found, float roots[4]) {
    answers[at] = float(found);
    for (uint k = 0u; k < 4u; ++k) {
        answers[at + 1u + k] = roots[k];
    }
}

void storeQuartic(uint at, TorusReducedQuartic quartic) {
    answers[at] = quartic.alpha;
    answers[at + 1u] = quartic.cz;
    answers[at + 2u] = quartic.beta;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    uint from = i * 8u;
    uint to = i * 32u;
    Torus torus = Torus(rays[from], rays[from + 1u]);
    vec3 origin = vec3(rays[from + 2u], rays[from + 3u], rays[from + 4u]);
    vec3 direction = vec3(rays[from + 5u], rays[from + 6u], rays[from + 7u]);
    float c[5];
    torusQuarticCoefficients(torus, origin, direction, c);
    for (uint k = 0u; k < 5u; ++k) {
        answers[to + k] = c[k];
    }
    TorusReducedRay ray;
    answers[to + 5u] = torusReduceRay(torus, origin, direction, ray) ? 1.0 : 0.0;
    float roots[4];
    int found = torusClosedFormRoots(torus, origin, direction, roots);
    storeRoots(to + 6u, found, roots);
    storeQuartic(to + 11u, torusAxialQuartic(ray));
    found = torusReducedRoots(torusAxialQuartic(ray), roots);
    storeRoots(to + 14u, found, roots);
    storeQuartic(to + 19u, torusRadialQuartic(ray));
    found = torusReducedRootsUnhalved(torusRadialQuartic(ray), roots);
    storeRoots(to + 22u, found, roots);
    answers[to + 27u] = torusBetaSum(ray);
    answers[to + 28u] = ray.tubeRadius;
    answers[to + 29u] = ray.shift;
    answers[to + 30u] = ray.scale;
    answers[to + 31u] = torusBetaProduct(ray);
}
