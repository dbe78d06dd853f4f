// SPDX-License-Identifier: MIT
// Method: marching to 1e-4 r on the library's reduced line, exact last step.
// Tolerance: 4e-7 (R + r).
//
// Sphere tracing at the library's accuracy, for a comparison of equals: the ray reduced as the library reduces it, marched
// to 1e-4 r as sphere_tracing.glsl does (Hart, The Visual Computer 12, 1996, pp. 527-545), and the hit then taken by the
// library's exact last step. Marching on to the last bit instead costs more and ends in the rounding of the distance.
//
// What it loses: hits that 128 steps do not reach: where the ray slants, or passes the surface by closely.
#ifndef SPHERE_TRACING_EXACT_GLSL
#define SPHERE_TRACING_EXACT_GLSL

#include "parts/exact_hit.glsl"

#define MARCH_STEPS 128
#define MARCH_NEAR 1.0e-4
// The longest step across a surface, in r: less than any gap or chord that is no graze.
#define MARCH_ACROSS 0.05

float marchDistance(torus_Line line, float u) {
    return torusDistance(Torus(line.majorRadius, line.minorRadius), line.foot + u * line.direction);
}

// To the next surface at or beyond u, from the inside if `inside`.
bool marchOn(torus_Line line, float perLength, bool inside, inout float u) {
    float near = MARCH_NEAR * line.minorRadius;
    for (int i = 0; i < MARCH_STEPS && u <= line.upper; ++i) {
        float distance = marchDistance(line, u);
        distance = inside ? -distance : distance;
        if (distance < near) {
            return true;
        }
        u += distance * perLength;
    }
    return false;
}

// Away from a surface just met, until it is clear on which side.
void marchAcross(torus_Line line, float perLength, inout float u, inout bool inside) {
    float near = MARCH_NEAR * line.minorRadius;
    float step = 2.0 * near;
    for (int i = 0; i < MARCH_STEPS; ++i) {
        u += step * perLength;
        float distance = marchDistance(line, u);
        if (abs(distance) > near) {
            inside = distance < 0.0;
            return;
        }
        step = min(2.0 * step, MARCH_ACROSS * line.minorRadius);
    }
}

// The start of marching.
bool marchesInside(torus_Line line) {
    return line.fromStart && marchDistance(line, line.lower) < 0.0;
}

bool marchIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    bool clipped = line.meets && torus_clip(line, tMin, tMax);
    bool inside = marchesInside(line);
    float u = line.lower;
    if (clipped && marchOn(line, inversesqrt(line.length2), inside, u)) {
        torus_Crossing crossing = exactHitAt(line, u, inside);
        hits = crossing.found && torus_isWithin(line, crossing);
        if (hits) {
            nearest = torus_hitAt(line, crossing, tMin, tMax);
        }
    }
    hit = nearest;
    return hits;
}

bool marchOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    bool clipped = line.meets && torus_clip(line, tMin, tMax);
    float u = line.lower;
    return clipped && marchOn(line, inversesqrt(line.length2), marchesInside(line), u);
}

int marchIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    float perLength = inversesqrt(line.length2);
    bool clipped = line.meets && torus_clip(line, tMin, tMax);
    bool inside = marchesInside(line);
    float u = line.lower;
    while (clipped && count < 4 && marchOn(line, perLength, inside, u)) {
        bool before = inside;
        float met = u;
        marchAcross(line, perLength, u, inside);
        // Back on the same side: a graze, into the solid and out of it within the stopping distance.
        int crossings = before == inside ? 2 : 1;
        for (int i = 0; i < crossings && count < 4; ++i) {
            torus_Crossing crossing = exactHitAt(line, met, i == 0 ? before : !before);
            if (crossing.found && torus_isWithin(line, crossing)) {
                hits[count] = torus_hitAt(line, crossing, tMin, tMax);
                ++count;
            }
        }
    }
    return count;
}

#define RAY_INTERSECT marchIntersect
#define RAY_OCCLUDED marchOccluded
#define RAY_INTERSECT_ALL marchIntersectAll

#endif
