// SPDX-License-Identifier: MIT
// From a method's rough roots to the three questions, the same for every method on the reduced quartic: the library's
// reduction before, its exact last step after. The including file names the method by macros:
//
//     QUARTIC_INTERSECT, QUARTIC_OCCLUDED, QUARTIC_INTERSECT_ALL    the functions to define
//     QUARTIC_STATE                     what the method knows of a line before it looks for a root
//     QUARTIC_STATE QUARTIC_PREPARE(torus_Line line)
//     bool QUARTIC_ROOT(torus_Line line, QUARTIC_STATE state, int index, out float u)
//                                       root 0 to 3 of the outer sheet on the whole line, ascending, if it exists

#include "reduced_quartic.glsl"

// A rough root this near to an end of the ray, in r, may be moved past it by the last step.
#define QUARTIC_ROOM 0.015625

bool QUARTIC_INTERSECT(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = torus_miss(tMax);
    torus_Line line;
    if (!torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax, line)) {
        return false;
    }
    QUARTIC_STATE state = QUARTIC_PREPARE(line);
    TORUS_PRECISE float from = line.lower - QUARTIC_ROOM * line.minorRadius;
    bool found = false;
    for (int i = 0; i < 4 && !found; ++i) {
        float u = 0.0;
        if (QUARTIC_ROOT(line, state, i, u) && u >= from) {
            float exactU;
            TorusHit candidate = torus_hit(line, u, tMin, tMax, exactU);
            found = exactU >= line.lower;
            if (exactU > line.upper) {
                return false;
            }
            if (found) {
                hit = candidate;
            }
        }
    }
    return found;
}

// Without the last step, but where a rough root lies near an end of the ray.
bool QUARTIC_OCCLUDED(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    torus_Line line;
    if (!torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax, line)) {
        return false;
    }
    QUARTIC_STATE state = QUARTIC_PREPARE(line);
    TORUS_PRECISE float room = QUARTIC_ROOM * line.minorRadius;
    bool found = false;
    for (int i = 0; i < 4 && !found; ++i) {
        float u = 0.0;
        bool exists = QUARTIC_ROOT(line, state, i, u);
        if (exists && min(abs(u - line.lower), abs(u - line.upper)) <= room) {
            torus_hit(line, u, tMin, tMax, u);
        }
        found = exists && u >= line.lower && u <= line.upper;
    }
    return found;
}

int QUARTIC_INTERSECT_ALL(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    torus_Line line;
    if (!torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax, line)) {
        return 0;
    }
    QUARTIC_STATE state = QUARTIC_PREPARE(line);
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        float u = 0.0;
        if (QUARTIC_ROOT(line, state, i, u)) {
            float exactU;
            TorusHit hit = torus_hit(line, u, tMin, tMax, exactU);
            if (exactU >= line.lower && exactU <= line.upper) {
                hits[count] = hit;
                ++count;
            }
        }
    }
    return count;
}
