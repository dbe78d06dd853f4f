// SPDX-License-Identifier: MIT
// Baseline: no intersection; what making rays and using answers costs, which is taken from all other times.
//
// The answer depends on every number of the ray, so that no compiler leaves its making out.
#ifndef EMPTY_GLSL
#define EMPTY_GLSL

#include "torus/torus.glsl"

bool emptyIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = TorusHit(tMin + torus.minorRadius, origin + direction);
    return hit.position.x < tMax;
}

bool emptyOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    vec3 sum = origin + direction;
    return sum.x + sum.y + sum.z + torus.minorRadius < tMin;
}

int emptyIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    vec3 sum = origin + direction;
    hits[0] = TorusHit(tMin + torus.minorRadius, sum);
    hits[1] = hits[0];
    hits[2] = hits[0];
    hits[3] = hits[0];
    return sum.x < tMax ? 1 : 0;
}

#define RAY_INTERSECT emptyIntersect
#define RAY_OCCLUDED emptyOccluded
#define RAY_INTERSECT_ALL emptyIntersectAll

#endif
