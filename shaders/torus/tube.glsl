// SPDX-License-Identifier: MIT
// Private: where a line meets the tube. Knows no rays and no units.
//
// Everything rests on one function of the line's parameter u, the squared distance to the tube's centre circle less
// r^2, which is negative inside the solid and, unlike the quartic, knows no inner sheet:
//
//     G(u) = (rho(u) - R)^2 + z(u)^2 - r^2 = u^2 + K - 2 R rho(u),    rho(u) = |(x(u), y(u))|
//
// rho is a hyperbola, hence convex, and its third derivative changes sign once, at u = c, where the line passes
// closest to the axis. So half the derivative, g = G'/2 = u - R rho'(u), is concave left of c and convex right of it
// (mirror the line so that c >= 0; then g(c) = c >= 0):
//   - left of c, g has one root: a minimum of G. Newton from -R sqrt(n), left of it, climbs to it monotonically.
//   - right of c, g has two roots or none: a maximum and a minimum of G. Newton from +R sqrt(n), right of them,
//     descends to the minimum monotonically; a slope that is not positive, or a step past c, proves that there is none.
// G is monotone between its extrema: their signs count the roots, and each root has a bracket.
#ifndef TORUS_TUBE_GLSL
#define TORUS_TUBE_GLSL

#include "line.glsl"

// Steps to an extremum. Newton halves the error of a nearly double root of g (where minimum and maximum merge, and G
// is as flat as a quartic at its extremum): 16 halvings leave a dip of (2^-16)^4 unseen, far below the rounding of G.
#define TORUS_EXTREMUM_STEPS 16
// Steps to a root: Newton where it stays in the bracket, else bisection. 48 bisections exhaust float32.
#define TORUS_ROOT_STEPS 48
// An extremum is near enough when a step is shorter than this part of r; the next error is its square, and G is flat.
#define TORUS_EXTREMUM_STEP 0.00390625
// A root is near enough when a step is shorter than this part of R + r, some two ulp, or when G is less than this part
// of r (R + r), which is its rounding: without the second, Newton hops to and fro for ever near a tangent.
#define TORUS_ROOT_STEP 2.4e-7
#define TORUS_ROOT_VALUE 1.2e-7

// G and half its slope at u, evaluated from the point itself: (rho - R - r)(rho - R + r) + z^2 rounds to some 2^-24 of
// r (R + r) near the surface, where the polynomial would round to 2^-24 (R + r)^2 and lose a thin tube.
float torus_tube(torus_Line line, float u, out float slope) {
    TORUS_PRECISE float x = line.foot.x + u * line.direction.x;
    TORUS_PRECISE float y = line.foot.y + u * line.direction.y;
    TORUS_PRECISE float z = line.foot.z + u * line.direction.z;
    TORUS_PRECISE float rho = sqrt(x * x + y * y);
    TORUS_PRECISE float q = rho - line.majorRadius;
    TORUS_PRECISE float value = (q - line.minorRadius) * (q + line.minorRadius) + z * z;
    TORUS_PRECISE float along = x * line.direction.x + y * line.direction.y;
    TORUS_PRECISE float radial = along + z * line.direction.z;
    // On the axis rho' jumps from -n to n: the slope of either side would do, and that of neither is finite.
    TORUS_PRECISE float rhoSlope = rho > 0.0 ? along / rho : 0.0;
    TORUS_PRECISE float halfSlope = radial - line.majorRadius * rhoSlope;
    slope = halfSlope;
    return value;
}

// The extrema of G along the line, in ascending order of u.
struct torus_Extrema {
    float firstMinimum;
    float firstValue;         // G there
    float firstFlatness;      // 2 / G'' there, about; positive
    float secondMinimum;      // as the first one where there is only one
    float secondValue;
    float secondFlatness;
    bool  hasSecond;
    float axis;               // c: where the line is closest to the axis (0 for a line parallel to it)
};

torus_Extrema torus_extrema(torus_Line line) {
    TORUS_PRECISE float n = line.direction.x * line.direction.x + line.direction.y * line.direction.y;
    TORUS_PRECISE float m = line.foot.x * line.direction.x + line.foot.y * line.direction.y;
    TORUS_PRECISE float rho2 = line.foot.x * line.foot.x + line.foot.y * line.foot.y;
    // Mirror the line so that it passes the axis at c >= 0.
    TORUS_PRECISE float mirror = m > 0.0 ? -1.0 : 1.0;
    m = -abs(m);
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float c = n > 0.0 ? -m / n : 0.0;
    TORUS_PRECISE float reach = R * sqrt(n);
    TORUS_PRECISE float left = -reach;
    TORUS_PRECISE float right = reach;
    bool hasRight = reach > c;
    TORUS_PRECISE float leftFlatness = 1.0;
    TORUS_PRECISE float rightFlatness = 1.0;
    TORUS_PRECISE float enough = TORUS_EXTREMUM_STEP * line.minorRadius;
    bool busy = true;
    for (int i = 0; i < TORUS_EXTREMUM_STEPS && busy; ++i) {
        // g / g' = (u rho - R s) rho^2 / (rho^3 - R (n rho^2 - s^2)), s = rho rho' = n u + m
        TORUS_PRECISE float sLeft = n * left + m;
        TORUS_PRECISE float square = max((sLeft + m) * left + rho2, 1.0e-20);
        TORUS_PRECISE float rho = sqrt(square);
        TORUS_PRECISE float cube = rho * square;
        TORUS_PRECISE float bend = cube - R * (n * square - sLeft * sLeft);
        TORUS_PRECISE float perBend = 1.0 / max(bend, 1.0e-20);
        TORUS_PRECISE float step = (R * sLeft - left * rho) * square * perBend;
        step = clamp(step, 0.0, c - left);
        left = left + step;
        leftFlatness = cube * perBend;
        busy = step > enough;

        TORUS_PRECISE float sRight = n * right + m;
        square = max((sRight + m) * right + rho2, 1.0e-20);
        rho = sqrt(square);
        cube = rho * square;
        bend = cube - R * (n * square - sRight * sRight);
        hasRight = hasRight && bend > 0.0 && right > c;
        perBend = 1.0 / max(bend, 1.0e-20);
        step = hasRight ? (right * rho - R * sRight) * square * perBend : 0.0;
        right = right - max(step, 0.0);
        rightFlatness = cube * perBend;
        busy = busy || step > enough;
    }
    hasRight = hasRight && right > c;
    right = hasRight ? right : left;
    rightFlatness = hasRight ? rightFlatness : leftFlatness;

    torus_Extrema extrema;
    bool mirrored = mirror < 0.0;
    float slope;
    float leftValue = torus_tube(line, mirror * left, slope);
    float rightValue = torus_tube(line, mirror * right, slope);
    extrema.hasSecond = hasRight;
    extrema.axis = mirror * c;
    extrema.firstMinimum = mirrored ? -right : left;
    extrema.firstValue = mirrored ? rightValue : leftValue;
    extrema.firstFlatness = mirrored ? rightFlatness : leftFlatness;
    extrema.secondMinimum = mirrored ? -left : right;
    extrema.secondValue = mirrored ? leftValue : rightValue;
    extrema.secondFlatness = mirrored ? leftFlatness : rightFlatness;
    return extrema;
}

// The maximum of G between its two minima: Newton from c, monotone. Costs nothing unless `wanted`.
float torus_maximum(torus_Line line, torus_Extrema extrema, bool wanted, out float value) {
    TORUS_PRECISE float n = line.direction.x * line.direction.x + line.direction.y * line.direction.y;
    TORUS_PRECISE float m = line.foot.x * line.direction.x + line.foot.y * line.direction.y;
    TORUS_PRECISE float rho2 = line.foot.x * line.foot.x + line.foot.y * line.foot.y;
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float u = clamp(extrema.axis, extrema.firstMinimum, extrema.secondMinimum);
    TORUS_PRECISE float enough = TORUS_EXTREMUM_STEP * line.minorRadius;
    bool busy = wanted;
    for (int i = 0; i < TORUS_EXTREMUM_STEPS && busy; ++i) {
        TORUS_PRECISE float s = n * u + m;
        TORUS_PRECISE float square = max((s + m) * u + rho2, 1.0e-20);
        TORUS_PRECISE float rho = sqrt(square);
        TORUS_PRECISE float bend = rho * square - R * (n * square - s * s);
        TORUS_PRECISE float step = (R * s - u * rho) * square / min(bend, -1.0e-20);
        TORUS_PRECISE float next = clamp(u + step, extrema.firstMinimum, extrema.secondMinimum);
        busy = abs(next - u) > enough;
        u = next;
    }
    float slope;
    value = wanted ? torus_tube(line, u, slope) : 1.0;
    return u;
}

// The root of G in [lower, upper], where G changes sign; `rising` says whether it goes from inside to outside. A start
// outside the bracket is replaced by its middle.
float torus_root(torus_Line line, float lower, float upper, bool rising, float start, bool wanted) {
    TORUS_PRECISE float lo = lower;
    TORUS_PRECISE float hi = upper;
    TORUS_PRECISE float u = start > lo && start < hi ? start : 0.5 * (lo + hi);
    TORUS_PRECISE float enough = TORUS_ROOT_STEP * (line.majorRadius + line.minorRadius);
    TORUS_PRECISE float noise = TORUS_ROOT_VALUE * line.minorRadius * (line.majorRadius + line.minorRadius);
    bool busy = wanted;
    for (int i = 0; i < TORUS_ROOT_STEPS && busy; ++i) {
        float slope;
        TORUS_PRECISE float value = torus_tube(line, u, slope);
        bool tooFar = rising == (value > 0.0);
        lo = tooFar ? lo : u;
        hi = tooFar ? u : hi;
        TORUS_PRECISE float next = u - 0.5 * value / slope;
        bool trusted = next >= lo && next <= hi;
        next = trusted ? next : 0.5 * (lo + hi);
        busy = abs(next - u) > enough && abs(value) > noise;
        u = next;
    }
    return u;
}

#endif
