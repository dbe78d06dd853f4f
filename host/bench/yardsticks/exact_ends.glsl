// SPDX-License-Identifier: MIT
// The floor of exactness: the library without all that finds a crossing. What its reduction costs, its culling, and one
// last step of a clear crossing from the end of the line that is left of the ray; any-hit needs no last step. Its answers
// are wrong, and no method that begins and ends as exactly can be faster.
#ifndef EXACT_ENDS_GLSL
#define EXACT_ENDS_GLSL

#include "torus/torus.glsl"

// The last step of a clear crossing, without the question whether this is one.
TorusHit exactEndsHit(torus_Line line, float u, bool rising, float tMin, float tMax) {
    torus_End end = torus_clearStep(line, torus_quartic(line), u, rising);
    return torus_hitAt(line, end, tMin, tMax);
}

bool exactEndsIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    torus_Ray ray = torus_scale(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (ray.meets) {
        torus_Line line = torus_reduce(ray, tMin, tMax);
        hits = torus_cut(line);
        if (hits) {
            nearest = exactEndsHit(line, line.lower, false, tMin, tMax);
        }
    }
    hit = nearest;
    return hits;
}

bool exactEndsOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    bool hits = false;
    torus_Ray ray = torus_scale(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (ray.meets) {
        torus_Line line = torus_reduce(ray, tMin, tMax);
        hits = torus_cut(line);
    }
    return hits;
}

int exactEndsIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    torus_Ray ray = torus_scale(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (ray.meets) {
        torus_Line line = torus_reduce(ray, tMin, tMax);
        if (torus_cut(line)) {
            for (int i = 0; i < 2; ++i) {
                bool rising = i == 1;
                hits[i] = exactEndsHit(line, rising ? line.upper : line.lower, rising, tMin, tMax);
            }
            count = 2;
        }
    }
    return count;
}

#define RAY_INTERSECT exactEndsIntersect
#define RAY_OCCLUDED exactEndsOccluded
#define RAY_INTERSECT_ALL exactEndsIntersectAll

#endif
