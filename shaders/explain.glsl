// SPDX-License-Identifier: MIT
// One ray asked of every function of the library and of every step of the closed form.
#ifndef EXPLAIN_GLSL
#define EXPLAIN_GLSL

#include "torus/closed_form.glsl"
#include "explain_io.h"

float[3] explainFloats(vec3 v) {
    return float[3](v.x, v.y, v.z);
}

ExplainHit explainHit(Torus torus, TorusHit hit, bool found) {
    vec3 normal = found ? torusNormal(torus, hit.position) : vec3(0.0);
    vec2 uv = found ? torusUv(torus, hit.position) : vec2(0.0);
    return ExplainHit(hit.t, explainFloats(hit.position), explainFloats(normal), float[2](uv.x, uv.y));
}

void explainHits(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, inout ExplainAnswer answer) {
    TorusHit nearest;
    bool found = torusIntersect(torus, origin, tMin, direction, tMax, nearest);
    answer.found = int(found);
    answer.nearest = explainHit(torus, nearest, found);
    answer.occluded = int(torusOccluded(torus, origin, tMin, direction, tMax));
    TorusHit hits[4];
    answer.count = torusIntersectAll(torus, origin, tMin, direction, tMax, hits);
    for (int i = 0; i < 4; ++i) {
        answer.hits[i] = explainHit(torus, hits[i], i < answer.count);
    }
}

void explainReduced(TorusReducedRay ray, inout ExplainAnswer answer) {
    answer.origin = explainFloats(ray.origin);
    answer.direction = explainFloats(ray.direction);
    answer.tubeRadius = ray.tubeRadius;
    answer.shift = ray.shift;
    answer.scale = ray.scale;
    TorusReducedQuartic quartic = torusAxialQuartic(ray);
    TorusReducedQuartic radial = torusRadialQuartic(ray);
    answer.alpha = quartic.alpha;
    answer.cz = quartic.cz;
    answer.beta = quartic.beta;
    answer.alphaRadial = radial.alpha;
    answer.czRadial = radial.cz;
    answer.betaSum = torusBetaSum(ray);
    torus_Resolvent g = torus_resolvent(quartic);
    answer.gamma = g.gamma;
    answer.delta = g.delta;
    answer.epsilon = g.epsilon;
    answer.zeta = g.epsilon < 0.0 ? 0.0 : torus_zeta(g, 0.5);
    answer.y = torus_resolventRoot(g, 0.5, 1.0);
    answer.innerSquare = torus_innerSquare(quartic, answer.y);
}

void explainClosedForm(Torus torus, vec3 origin, vec3 direction, inout ExplainAnswer answer) {
    torusQuarticCoefficients(torus, origin, direction, answer.coefficients);
    TorusReducedRay ray;
    bool meets = torusReduceRay(torus, origin, direction, ray);
    answer.meets = int(meets);
    if (meets) {
        explainReduced(ray, answer);
    }
    answer.rootCount = torusClosedFormRoots(torus, origin, direction, answer.roots);
}

#endif
