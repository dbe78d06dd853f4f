// SPDX-License-Identifier: MIT
// Method: the reduced quartic by its formula, as it stands in the library's derivation.
// Tolerance: 2e-3 (R + r).
//
// The closed form as docs/math.md derives it and shaders/torus/closed_form.glsl spells it, and nothing done to mend it:
// its roots are the hits, but for those on the inner sheet of a spindle. Without hits for R = 0 and r > 100 R, which
// closed_form.glsl refuses.
#ifndef CLOSED_FORM_GLSL
#define CLOSED_FORM_GLSL

#include "torus/closed_form.glsl"

int closedFormIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    // Sorts out bad input, and rays that end before the torus.
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    TorusReducedRay ray;
    if (line.meets && torus_clip(line, tMin, tMax) && torusReduceRay(torus, origin, direction, ray)) {
        float roots[4];
        int found = torusReducedRoots(torusAxialQuartic(ray), roots);
        for (int i = 0; i < found; ++i) {
            TORUS_PRECISE float t = ray.shift + ray.scale * roots[i];
            TORUS_PRECISE vec3 point = ray.origin + roots[i] * ray.direction;
            // 2 rho on the outer sheet, -2 rho on the inner one (math.md, eq. 2).
            TORUS_PRECISE float sheet =
                point.x * point.x + point.y * point.y + point.z * point.z + 1.0 - ray.tubeRadius * ray.tubeRadius;
            if (t >= tMin && t <= tMax && sheet >= 0.0) {
                TORUS_PRECISE vec3 position = torus.majorRadius * point;
                hits[count] = TorusHit(t, position);
                ++count;
            }
        }
    }
    return count;
}

bool closedFormIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit hits[4];
    bool found = closedFormIntersectAll(torus, origin, tMin, direction, tMax, hits) > 0;
    hit = hits[0];
    return found;
}

bool closedFormOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    TorusHit hits[4];
    return closedFormIntersectAll(torus, origin, tMin, direction, tMax, hits) > 0;
}

#define RAY_INTERSECT closedFormIntersect
#define RAY_OCCLUDED closedFormOccluded
#define RAY_INTERSECT_ALL closedFormIntersectAll

#endif
