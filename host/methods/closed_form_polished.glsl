// SPDX-License-Identifier: MIT
// Method: the reduced quartic by its formula, mended: polished resolvent, exact last step.
// Tolerance: 4e-7 (R + r).
//
// The closed form of the reduced quartic f(u) = u^4 + 2 alpha u^2 + 8 c z u + beta, as far as float32 carries it:
//
//     gamma = 16 alpha^3 - 144 alpha beta + 1728 (c z)^2,    delta = 4 alpha^2 + 12 beta,
//     epsilon = gamma^2 - 4 delta^3,    zeta = cbrt((gamma + sqrt(epsilon)) / 2),    y = (zeta + delta / zeta) / 3,
//     S = sqrt(y - 4/3 alpha),    u = (-S +- sqrt(-y - 8/3 alpha + 16 c z / S)) / 2 and
//                                 u = ( S +- sqrt(-y - 8/3 alpha - 16 c z / S)) / 2
//
// Ferrari's solution with Descartes' two quadratics (van der Waerden, Algebra I, section 64), complete:
//   - epsilon < 0 (four real roots or none) makes zeta complex; y is then 2/3 sqrt(delta) cos(phi / 3), the cosine
//     a polynomial (third_cosine.glsl);
//   - epsilon = (gamma - D)(gamma + D), D = 2 delta^(3/2), cancels less than the difference of the squares;
//   - zeta takes the sign that adds; zeta = 0 only where gamma and delta are 0, and y with them;
//   - S^2 is the largest root of the resolvent cubic, so the quadratics pair the two lower and the two upper roots;
//   - one Newton step on the resolvent cubic itself mends S^2;
//   - 16 c z / S is 0 / 0 in the planes of symmetry; its square is 4 ((2 alpha + S^2)^2 - 4 beta), which for beta < 0
//     does not cancel. For beta > 0 and S = 0 there are no roots.
// What it loses: verdicts where a discriminant is smaller than the rounding of alpha^2, as many are in a tube of 0.001 R.
// And along the axis of a spindle, where both sheets' roots are one, it counts both.
#ifndef CLOSED_FORM_POLISHED_GLSL
#define CLOSED_FORM_POLISHED_GLSL

#include "parts/cube_root.glsl"
#include "parts/reduced_quartic.glsl"
#include "parts/third_cosine.glsl"

struct PolishedForm {
    float k;              // as in ReducedQuartic
    float middle;         // S / 2: the pairs lie around -S / 2 and S / 2
    float leftSquare;     // their discriminants / 4
    float rightSquare;
};

// y: the largest root of the depressed resolvent cubic.
float polishedFormResolvent(float gamma, float delta) {
    TORUS_PRECISE float root = sqrt(max(delta, 0.0));
    TORUS_PRECISE float edge = 2.0 * delta * root;
    TORUS_PRECISE float epsilon =
        delta > 0.0 ? (gamma - edge) * (gamma + edge) : gamma * gamma - 4.0 * delta * delta * delta;
    if (epsilon < 0.0) {
        TORUS_PRECISE float x = gamma / edge;
        TORUS_PRECISE float y = (2.0 / 3.0) * root * thirdCosine(sqrt(clamp(0.5 + 0.5 * x, 0.0, 1.0)));
        return y;
    }
    TORUS_PRECISE float sum = 0.5 * (gamma < 0.0 ? gamma - sqrt(epsilon) : gamma + sqrt(epsilon));
    TORUS_PRECISE float zeta = cubeRoot(sum);
    TORUS_PRECISE float y = zeta != 0.0 ? (zeta + delta / zeta) * (1.0 / 3.0) : 0.0;
    return y;
}

// One step of Newton's method on the resolvent cubic itself, x^3 + 2 p x^2 + (p^2 - 4 s) x - q^2, takes back most of what
// the sixth powers of the formula have lost.
float polishedFormPolish(ReducedQuartic f, float x) {
    TORUS_PRECISE float linear = f.p * f.p - 4.0 * f.s;
    TORUS_PRECISE float value = ((x + 2.0 * f.p) * x + linear) * x - f.q * f.q;
    TORUS_PRECISE float slope = (3.0 * x + 4.0 * f.p) * x + linear;
    TORUS_PRECISE float polished = slope > 0.0 ? x - value / slope : x;
    return max(polished, 0.0);
}

PolishedForm polishedFormPrepare(torus_Line line) {
    ReducedQuartic f = reducedQuartic(line);
    // p = 2 alpha, q = 8 c z, s = beta
    TORUS_PRECISE float gamma = 2.0 * f.p * (f.p * f.p - 36.0 * f.s) + 27.0 * f.q * f.q;
    TORUS_PRECISE float delta = f.p * f.p + 12.0 * f.s;
    float y = polishedFormResolvent(gamma, delta);
    TORUS_PRECISE float formula = y - (2.0 / 3.0) * f.p;
    float square = polishedFormPolish(f, formula);
    TORUS_PRECISE float S = sqrt(square);
    TORUS_PRECISE float sum = f.p + square;
    TORUS_PRECISE float ratio = 0.0;
    if (f.s < 0.0) {
        ratio = sqrt(sum * sum - 4.0 * f.s);
        ratio = f.q < 0.0 ? -ratio : ratio;
    } else {
        ratio = S > 0.0 ? f.q / S : 0.0;
    }
    PolishedForm state;
    state.k = f.k;
    TORUS_PRECISE float middle = 0.5 * S;
    TORUS_PRECISE float left = 0.25 * (2.0 * (ratio - f.p) - square);
    TORUS_PRECISE float right = 0.25 * (-2.0 * (ratio + f.p) - square);
    state.middle = middle;
    state.leftSquare = left;
    state.rightSquare = right;
    return state;
}

bool polishedFormRoot(torus_Line line, PolishedForm state, int index, out float u) {
    bool left = index < 2;
    float square = left ? state.leftSquare : state.rightSquare;
    TORUS_PRECISE float width = sqrt(max(square, 0.0));
    TORUS_PRECISE float root =
        (left ? -state.middle : state.middle) + (index == 0 || index == 2 ? -width : width);
    u = root;
    // The inner sheet of a spindle has roots too.
    TORUS_PRECISE float sheet = u * u + state.k;
    return square >= 0.0 && sheet >= 0.0;
}

#define QUARTIC_INTERSECT polishedFormIntersect
#define QUARTIC_OCCLUDED polishedFormOccluded
#define QUARTIC_INTERSECT_ALL polishedFormIntersectAll
#define QUARTIC_STATE PolishedForm
#define QUARTIC_PREPARE polishedFormPrepare
#define QUARTIC_ROOT polishedFormRoot
#include "parts/quartic_hits.glsl"

#define RAY_INTERSECT polishedFormIntersect
#define RAY_OCCLUDED polishedFormOccluded
#define RAY_INTERSECT_ALL polishedFormIntersectAll

#endif
