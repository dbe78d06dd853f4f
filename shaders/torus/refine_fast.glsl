// SPDX-License-Identifier: MIT
// Private: the last step of the fast tier, by the tube function in float32:
//
//     G(p) = (rho - R)^2 + z^2 - r^2,    rho = |(x, y)|                               (math.md, eq. 24)
//
// The march's f loses digits in a thin tube; rho - R does not.
#ifndef TORUS_REFINE_FAST_GLSL
#define TORUS_REFINE_FAST_GLSL

#include "crossing.glsl"

// Steps to the next crossing. Four do for most; the rest is for tangents.
#define TORUS_STEPS 64

// The crossing that the march has come to. It goes on from there, on the other side.
torus_Crossing torus_refine(const torus_Line line, inout torus_March march) {
    TORUS_ON_REFINEMENT
    TORUS_PRECISE vec3 d = line.direction;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE vec3 p = line.foot + march.u * d;
    TORUS_PRECISE float rho = sqrt(p.x * p.x + p.y * p.y);
    TORUS_PRECISE float q = rho - line.majorRadius;
    TORUS_PRECISE float tube = (q - r) * (q + r) + p.z * p.z;
    TORUS_PRECISE float invRho = 1.0 / max(rho, TORUS_AXIS);
    TORUS_PRECISE float slope = (p.x * d.x + p.y * d.y) * invRho * q + p.z * d.z;
    TORUS_PRECISE float across = (p.x * d.y - p.y * d.x) * invRho;
    TORUS_PRECISE float bend = line.majorRadius * (across * across * invRho);
    TORUS_PRECISE float g = march.side * tube;
    TORUS_PRECISE float s = march.side * slope;
    TORUS_PRECISE float C = march.side * (line.length2 - bend);
    TORUS_PRECISE float root = sqrt(max(s * s - C * g, 0.0));
    TORUS_PRECISE float step = s < 0.0 ? g / (root - s) : 0.0;
    TORUS_PRECISE float x = clamp(step, -TORUS_LAST_STEP * r, TORUS_LAST_STEP * r);
    TORUS_PRECISE vec3 position = p + x * d;
    TORUS_PRECISE float crossing = march.u + x;
    TORUS_PRECISE float beyond = crossing + TORUS_CLEARANCE;
    march.u = beyond;
    march.side = -march.side;
    march.reach = torus_firstReach(line, march.side);
    march.refines = false;
    return torus_Crossing(true, position, line.shift, crossing);
}

// The next crossing.
torus_Crossing torus_nextCrossing(const torus_Line line, const torus_Quartic quartic, inout torus_March march) {
    torus_Crossing crossing = torus_noCrossing();
    torus_search(quartic, line.upper, TORUS_STEPS, march);
    if (march.refines) {
        crossing = torus_refine(line, march);
    }
    return crossing;
}

// Whether there is a crossing before the ray's end. Its place need not be refined.
bool torus_crosses(const torus_Line line, const torus_Quartic quartic, inout torus_March march) {
    torus_search(quartic, line.upper, TORUS_STEPS, march);
    torus_Crossing crossing = torus_Crossing(march.refines, vec3(0.0, 0.0, 0.0), line.shift, march.u);
    return crossing.found && torus_isWithin(line, crossing);
}

#endif
