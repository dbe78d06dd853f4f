// SPDX-License-Identifier: MIT
// Baseline: the floor of exactness: the library's reduction and last step, with nothing found between.
//
// The library without all that finds a crossing. What its reduction costs, its culling, and one last step of a clear
// crossing from the end of the line that is left of the ray; any-hit needs no last step. Its answers are wrong, and no
// method that begins and ends as exactly can be faster.
#ifndef EXACT_ENDS_GLSL
#define EXACT_ENDS_GLSL

#include "torus/torus.glsl"

// One refinement, without a look whether it found anything.
TorusHit exactEndsHit(torus_Line line, float u, bool leaves, float tMin, float tMax) {
    torus_March march = torus_March(u, u, leaves ? -1.0 : 1.0, 0.0, true, true, false, false, 0.0, 0.0);
    return torus_hitAt(line, torus_refine(line, march), tMin, tMax);
}

bool exactEndsIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets && torus_clip(line, tMin, tMax)) {
        hits = true;
        nearest = exactEndsHit(line, line.lower, false, tMin, tMax);
    }
    hit = nearest;
    return hits;
}

bool exactEndsOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    return line.meets && torus_clip(line, tMin, tMax);
}

int exactEndsIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets && torus_clip(line, tMin, tMax)) {
        for (int i = 0; i < 2; ++i) {
            bool leaves = i == 1;
            hits[i] = exactEndsHit(line, leaves ? line.upper : line.lower, leaves, tMin, tMax);
        }
        count = 2;
    }
    return count;
}

#define RAY_INTERSECT exactEndsIntersect
#define RAY_OCCLUDED exactEndsOccluded
#define RAY_INTERSECT_ALL exactEndsIntersectAll

#endif
