// SPDX-License-Identifier: MIT
// Private: a crossing of a line with the torus, which both tiers make of what the march finds.
#ifndef TORUS_CROSSING_GLSL
#define TORUS_CROSSING_GLSL

#include "march.glsl"

// Nearer to the axis than this, in units, rho has no direction.
#define TORUS_AXIS 1.0e-12
// How far the march goes on from a crossing: beyond the rounding of u, so that it is not found again.
#define TORUS_CLEARANCE 1.9073486328e-6

struct torus_Crossing {
    bool found;
    vec3 position;  // in units
    float shift;    // from the line's base, in lengths of the direction ...
    float rest;     // ... and what is left of that
};

torus_Crossing torus_noCrossing() {
    return torus_Crossing(false, vec3(0.0, 0.0, 0.0), 0.0, 0.0);
}

// Whether a crossing is not beyond the end of the ray. The crossing is exact, and t may be rounded: from afar it has an ulp
// as long as the torus.
bool torus_isWithin(const torus_Line line, torus_Crossing crossing) {
    TORUS_PRECISE float left = (line.endShift - crossing.shift) - crossing.rest;
    return left >= 0.0;
}

#endif
