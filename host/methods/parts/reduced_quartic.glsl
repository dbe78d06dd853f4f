// SPDX-License-Identifier: MIT
// The torus' quartic along a reduced line. With K = |foot|^2 + R^2 - r^2, n = dx^2 + dy^2, m = foot.xy . d.xy and
// rho0 = |foot.xy|, a point of the line has |p|^2 + R^2 - r^2 = dd u^2 + K, because the foot is where the ray is
// closest to the centre, and so
//
//     f(u) = ((dd u^2 + K)^2 - 4 R^2 (n u^2 + 2 m u + rho0^2)) / dd^2 = u^4 + p u^2 + q u + s:
//
// the cubic term is gone, the inflections are symmetric, and nothing is larger than the torus.
// f is G(u) ((rho + R)^2 + z^2 - r^2) / dd^2, G the tube function of refine.glsl, so it has the roots of the inner sheet
// of a spindle too; on the outer sheet dd u^2 + K = 2 R rho is not negative.
//
// Everything is in the line's parameter u, `precise` as in the library, so that only the root finding differs.
#ifndef REDUCED_QUARTIC_GLSL
#define REDUCED_QUARTIC_GLSL

#include "torus/torus.glsl"

struct ReducedQuartic {
    float p;
    float q;
    float s;
    float k;        // K / dd: outer sheet where u^2 + k >= 0
    float reach;    // f is not negative at -reach and at reach: the bounding sphere
    float enough;   // a step to a root that is shorter than this is enough: the last step does the rest
};

// A step below this part of r is enough: the last step does the rest.
#define QUARTIC_ENOUGH 0.0009765625
// Steps to a root; near a tangent Newton only halves the error, 24 halvings exhaust float32.
#define QUARTIC_ROOT_STEPS 24

ReducedQuartic reducedQuartic(torus_Line line) {
    TORUS_PRECISE float perDd = 1.0 / line.length2;
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float n = line.direction.x * line.direction.x + line.direction.y * line.direction.y;
    TORUS_PRECISE float m = line.foot.x * line.direction.x + line.foot.y * line.direction.y;
    TORUS_PRECISE float rho2 = line.foot.x * line.foot.x + line.foot.y * line.foot.y;
    TORUS_PRECISE float z2 = line.foot.z * line.foot.z;
    TORUS_PRECISE float rho = sqrt(rho2);
    TORUS_PRECISE float inner = rho - R;
    TORUS_PRECISE float beyond = rho + R;
    // The constant as a product: expanded, its terms cancel to nothing of a thin tube.
    TORUS_PRECISE float tube = ((inner - line.minorRadius) * (inner + line.minorRadius) + z2) * perDd;
    TORUS_PRECISE float other = ((beyond - line.minorRadius) * (beyond + line.minorRadius) + z2) * perDd;
    TORUS_PRECISE float k = 0.5 * (tube + other);
    TORUS_PRECISE float scale = -4.0 * R * R * perDd * perDd;
    TORUS_PRECISE float p = 2.0 * k + scale * n;
    TORUS_PRECISE float q = 2.0 * scale * m;
    TORUS_PRECISE float s = tube * other;
    TORUS_PRECISE float enough = QUARTIC_ENOUGH * line.minorRadius;
    TORUS_PRECISE float outer = R + line.minorRadius;
    TORUS_PRECISE float reach = sqrt(max(TORUS_SPHERE_PADDING * outer * outer - line.foot2, 0.0) * perDd);
    return ReducedQuartic(p, q, s, k, reach, enough);
}

float quarticValue(ReducedQuartic f, float u) {
    TORUS_PRECISE float value = ((u * u + f.p) * u + f.q) * u + f.s;
    return value;
}

float quarticSlope(ReducedQuartic f, float u) {
    TORUS_PRECISE float slope = (4.0 * u * u + 2.0 * f.p) * u + f.q;
    return slope;
}

#endif
