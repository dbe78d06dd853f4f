// SPDX-License-Identifier: MIT
// From a rough root to an exact one, for methods that share the library's reduction and its refinement.
#ifndef EXACT_HIT_GLSL
#define EXACT_HIT_GLSL

#include "torus/torus.glsl"

// Refinements of one rough root.
#define EXACT_HIT_STEPS 24

// The tube function's sign at a place of the line, in plain float32.
bool exactHitInside(torus_Line line, float u) {
    TORUS_PRECISE vec3 p = line.foot + u * line.direction;
    TORUS_PRECISE float q = sqrt(p.x * p.x + p.y * p.y) - line.majorRadius;
    TORUS_PRECISE float tube = (q - line.minorRadius) * (q + line.minorRadius) + p.z * p.z;
    return tube < 0.0;
}

// The crossing near u, which leads out of the solid if `leaves`.
torus_Crossing exactHitAt(torus_Line line, float u, bool leaves) {
    torus_March march = torus_March(u, u, leaves ? -1.0 : 1.0, 0.0, true, true, false, false, 0.0, 0.0);
    torus_Crossing crossing = torus_noCrossing();
    for (int i = 0; i < EXACT_HIT_STEPS && march.refines; ++i) {
        TORUS_ON_STEP
        crossing = torus_refine(line, march);
    }
    return crossing;
}

#endif
