// SPDX-License-Identifier: MIT
// From a method's rough roots to the three queries, the same for every method on the reduced quartic: the library's
// reduction before, its exact last step after. The including file names the method by macros:
//
//     QUARTIC_INTERSECT, QUARTIC_OCCLUDED, QUARTIC_INTERSECT_ALL    the functions to define
//     QUARTIC_STATE       what the method knows of a line before it looks for a root
//     QUARTIC_STATE QUARTIC_PREPARE(torus_Line line)
//     bool QUARTIC_ROOT(torus_Line line, QUARTIC_STATE state, int index, out float u)
//                         crossing 0 to 3 of the outer sheet on the whole line, ascending, if it exists: the even ones
//                         lead into the solid, the odd ones out
//     bool QUARTIC_FIRST(torus_Line line, QUARTIC_STATE state, bool inside, float from, out float u)
//                         the first of them beyond `from` that leads out if `inside`, else in; may be left out
//     bool QUARTIC_BETWEEN(torus_Line line, QUARTIC_STATE state, bool inside)
//                         whether the ray crosses between two ends that are both inside, or both outside; may be left
//                         out

//     QUARTIC_DIPS        defined before: the state says what the minima say, of which both follow: first and second
//                         (the quartic dips below zero at them), firstMinimum and secondMinimum (where), joined (it
//                         stays below between them) and middle (else where it is largest there)

#include "exact_hit.glsl"
#include "reduced_quartic.glsl"

// Within this distance from an end of the ray, in r, the end's own side says better than a rough root what crosses.
#define QUARTIC_ROOM 0.015625

// Where a rough root has to lie to be ahead: anywhere if the ray enters through the bounding sphere.
float quarticFrom(torus_Line line) {
    TORUS_PRECISE float from = line.lower - QUARTIC_ROOM * line.minorRadius;
    return line.fromStart ? from : -TORUS_FLOAT_MAX;
}

#ifdef QUARTIC_DIPS
// The signs at the minima say which crossing is the first.
#define QUARTIC_FIRST quarticFirst
bool quarticFirst(torus_Line line, QUARTIC_STATE state, bool inside, float from, out float u) {
    bool firstAhead = state.first && state.firstMinimum >= line.lower;
    bool secondAhead = state.second && state.secondMinimum >= line.lower;
    bool leavesFirst = state.first && !state.joined && (!state.second || line.lower < state.middle);
    int index = inside ? (leavesFirst ? 1 : 3) : (firstAhead ? 0 : 2);
    return QUARTIC_ROOT(line, state, index, u) && (inside || firstAhead || secondAhead);
}

// Without a root: a dip lies between the ends, or a gap.
#define QUARTIC_BETWEEN quarticBetween
bool quarticBetween(torus_Line line, QUARTIC_STATE state, bool inside) {
    bool dip = (state.first && state.firstMinimum >= line.lower && state.firstMinimum <= line.upper) ||
               (state.second && state.secondMinimum >= line.lower && state.secondMinimum <= line.upper);
    bool gap = state.first && state.second && !state.joined && line.lower < state.middle &&
               line.upper > state.middle;
    return inside ? gap : dip;
}
#endif

#ifndef QUARTIC_FIRST
#define QUARTIC_FIRST quarticFirst
bool quarticFirst(torus_Line line, QUARTIC_STATE state, bool inside, float from, out float u) {
    bool found = false;
    u = 0.0;
    for (int i = inside ? 1 : 0; i < 4 && !found; i += 2) {
        found = QUARTIC_ROOT(line, state, i, u) && u >= from;
    }
    return found;
}
#endif

#ifndef QUARTIC_BETWEEN
#define QUARTIC_BETWEEN quarticBetween
bool quarticBetween(torus_Line line, QUARTIC_STATE state, bool inside) {
    TORUS_PRECISE float to = line.upper - QUARTIC_ROOM * line.minorRadius;
    float from = quarticFrom(line);
    float u = 0.0;
    return QUARTIC_FIRST(line, state, inside, from, u) && u <= to;
}
#endif

bool QUARTIC_INTERSECT(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets && torus_clip(line, tMin, tMax)) {
        QUARTIC_STATE state = QUARTIC_PREPARE(line);
        bool inside = exactHitInside(line, line.lower);
        float from = quarticFrom(line);
        float u = 0.0;
        if (QUARTIC_FIRST(line, state, inside, from, u)) {
            torus_Crossing crossing = exactHitAt(line, u, inside);
            hits = crossing.found && torus_isWithin(line, crossing);
            if (hits) {
                nearest = torus_hitAt(line, crossing, tMin, tMax);
            }
        }
    }
    hit = nearest;
    return hits;
}

// Ends on different sides, or a crossing between them.
bool QUARTIC_OCCLUDED(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    bool crosses = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets && torus_clip(line, tMin, tMax)) {
        QUARTIC_STATE state = QUARTIC_PREPARE(line);
        bool insideLower = exactHitInside(line, line.lower);
        bool insideUpper = exactHitInside(line, line.upper);
        bool between = QUARTIC_BETWEEN(line, state, insideLower);
        crosses = insideLower != insideUpper || between;
    }
    return crosses;
}

int QUARTIC_INTERSECT_ALL(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets && torus_clip(line, tMin, tMax)) {
        QUARTIC_STATE state = QUARTIC_PREPARE(line);
        float from = quarticFrom(line);
        for (int i = 0; i < 4; ++i) {
            float u = 0.0;
            if (QUARTIC_ROOT(line, state, i, u) && u >= from) {
                torus_Crossing crossing = exactHitAt(line, u, i % 2 == 1);
                TorusHit hit = torus_hitAt(line, crossing, -TORUS_FLOAT_MAX, tMax);
                if (crossing.found && hit.t >= tMin && torus_isWithin(line, crossing)) {
                    hits[count] = hit;
                    ++count;
                }
            }
        }
    }
    return count;
}
