// SPDX-License-Identifier: MIT
// Private: where a line meets the tube. Knows no rays and no units.
//
// Everything rests on one function of the line's parameter u, the squared distance to the tube's centre circle less
// r^2, which is negative inside the solid and, unlike the quartic, knows no inner sheet (math.md, eq. 24, 25, 26):
//
//     G(u) = (rho(u) - R)^2 + z(u)^2 - r^2 = dd u^2 + K - 2 R rho(u),    rho(u) = |(x(u), y(u))|
//
// rho is a hyperbola, hence convex, and its third derivative changes sign once, at u = c, where the line passes
// closest to the axis. So half the derivative, g = G'/2 = dd u - R rho'(u), is concave left of c and convex right of it
// (mirror the line so that c >= 0; then g(c) = dd c >= 0; dd is the squared length of the direction):
//   - left of c, g has one root: a minimum of G. Newton from -R sqrt(n) / dd, left of it, climbs to it monotonically.
//   - right of c, g has two roots or none: a maximum and a minimum of G. Newton from +R sqrt(n) / dd, right of them,
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
// Up to this part of r (R + r), rounding can have turned the sign of G: some ten roundings of its terms, a square root
// that is off by the 6.5 ulp that Vulkan allows, and the rounding of the foot.
#define TORUS_DOUBT 4.0e-6
// Where a minimum and a maximum of G nearly meet, as near a horn's tip, Newton only halves the way to each, and the
// curvature with it: this many times as much as the parabola says can be left of G.
#define TORUS_SETTLE_ROOM 8.0
// Exact steps to an extremum: one, and more while the third derivative, which the parabola leaves out, changes G there
// by more than this part.
#define TORUS_SETTLE_STEPS 4
#define TORUS_SETTLE_ORDER 0.125
// A root is near enough when a step is shorter than this part of r: Newton has squared the error by then, and the exact
// last step (last_step.glsl) cubes it. Or when G is less than this part of r (R + r), which is its rounding: without that,
// Newton hops to and fro for ever near a tangent.
#define TORUS_ROOT_STEP 0.0009765625
#define TORUS_ROOT_VALUE 1.2e-7
// Nearer to the axis than this, in units, the direction of rho is lost in rounding: its slope, which jumps there, fades
// to 0 instead of becoming anything.
#define TORUS_AXIS 1.0e-6
// The same for a point that is known exactly, to some 2^-40.
#define TORUS_EXACT_AXIS 1.0e-12

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
    TORUS_PRECISE float rhoSlope = along / max(rho, TORUS_AXIS);
    TORUS_PRECISE float halfSlope = radial - line.majorRadius * rhoSlope;
    slope = halfSlope;
    return value;
}

// A point of the line, known to more digits than a float has.
struct torus_Point {
    vec3 high;
    vec3 low;
    float shift;          // how far it is from the line's base, in lengths of the direction ...
    float shiftLow;       // ... and what is left of that
    float tube;           // G there, to some 2^-45 of r (R + r)
    float halfSlope;      // half of G' there
    float halfCurvature;  // half of G'' there
    float sixthThird;     // a sixth of G''' there: all of it is the bend of rho, which is sharp near the axis
};

// The derivatives of G at a point of the line, in plain float32.
struct torus_Slopes {
    float halfSlope;
    float halfCurvature;
    float sixthThird;
};

torus_Slopes torus_slopes(torus_Line line, vec3 point, float perRho) {
    TORUS_PRECISE float along = point.x * line.direction.x + point.y * line.direction.y;
    TORUS_PRECISE float rhoSlope = along * perRho;
    TORUS_PRECISE float halfSlope = (along + point.z * line.direction.z) - line.majorRadius * rhoSlope;
    // n - rho'^2 by Lagrange's identity, which keeps its digits near the axis, where the difference is all rounding.
    TORUS_PRECISE float acrossSlope = (point.x * line.direction.y - point.y * line.direction.x) * perRho;
    TORUS_PRECISE float bend = line.majorRadius * ((acrossSlope * acrossSlope) * perRho);
    TORUS_PRECISE float halfCurvature = line.length2 - bend;
    TORUS_PRECISE float sixthThird = bend * rhoSlope * perRho;
    return torus_Slopes(halfSlope, halfCurvature, sixthThird);
}

torus_Point torus_exactPoint(torus_Line line, float u) {
    torus_Point point;
    // Any two floats that make up a place near u will do, as long as t is made of the same two.
    TORUS_PRECISE float place = line.shiftRest + u;
    TORUS_PRECISE float shift = line.shift + place;
    TORUS_PRECISE float shiftLow = place - (shift - line.shift);
    point.shift = shift;
    point.shiftLow = shiftLow;
    vec3 allLow;
    point.high = torus_advance3(line.base, line.baseLow, shift, shiftLow, line.direction, allLow);
    point.low = allLow;
    float x = point.high.x;
    float y = point.high.y;
    float z = point.high.z;
    // rho = root + rootLow: one Newton step on the exact residual of the rounded root.
    TORUS_PRECISE float root = sqrt(x * x + y * y);
    TORUS_PRECISE float perRoot = 1.0 / max(root, TORUS_EXACT_AXIS);
    TORUS_PRECISE float residual = torus_squareDifference(x, y, root) + 2.0 * (x * allLow.x + y * allLow.y);
    TORUS_PRECISE float rootLow = 0.5 * residual * perRoot;
    TORUS_PRECISE float q = root - line.majorRadius;
    TORUS_PRECISE float qLow = torus_sumError(root, -line.majorRadius, q) + rootLow;
    // In a thin tube q is so small that the square of its low part counts.
    TORUS_PRECISE float tube = torus_squareDifference(q, z, line.minorRadius) +
                               ((2.0 * q + qLow) * qLow + 2.0 * (z * allLow.z));
    point.tube = tube;
    torus_Slopes slopes = torus_slopes(line, point.high, perRoot);
    point.halfSlope = slopes.halfSlope;
    point.halfCurvature = slopes.halfCurvature;
    point.sixthThird = slopes.sixthThird;
    return point;
}

// The extrema of G along the line, in ascending order of u.
struct torus_Extrema {
    float firstMinimum;
    float firstValue;         // G there
    float firstFlatness;      // 2 / G'' there, about; positive
    float secondMinimum;      // as the first one where there is only one
    float secondValue;
    float secondFlatness;
    bool hasSecond;
    float middle;             // the maximum between the two ...
    float middleValue;
    bool isBetween;           // ... if there is one; else it is at one of them
};

// Whether rounding, or what is left of the way to an extremum of G, could turn the sign of G there.
bool torus_doubtful(torus_Line line, float value, float slope, float flatness) {
    TORUS_PRECISE float doubt = TORUS_DOUBT * line.minorRadius * (line.majorRadius + line.minorRadius);
    TORUS_PRECISE float left = TORUS_SETTLE_ROOM * (slope * slope * abs(flatness));
    TORUS_PRECISE float room = doubt + left;
    return abs(value) <= room;
}

// An exact step towards an extremum of G that u is near: a minimum for a positive flatness, else a maximum. Returns
// whether it needs another step; `last` says that there will be none, and that the value has to be right as it is.
bool torus_settle(torus_Line line, float flatness, bool last, inout float u, inout float value) {
    torus_Point point = torus_exactPoint(line, u);
    // To the extremum of the parabola with this value, slope and curvature.
    bool bends = point.halfCurvature * flatness > 0.0;
    TORUS_PRECISE float step = bends ? -point.halfSlope / point.halfCurvature : 0.0;
    TORUS_PRECISE float settled = point.tube + point.halfSlope * step;
    TORUS_PRECISE float thirdOrder = point.sixthThird * step * step * step;
    TORUS_PRECISE float smallOrder = TORUS_SETTLE_ORDER * settled;
    bool busy = abs(thirdOrder) > abs(smallOrder);
    // A parabola that does not fit decides nothing: then the value is that of a point of the line.
    TORUS_PRECISE float next = busy && last ? u : u + step;
    u = next;
    value = busy ? point.tube : settled;
    return busy && !last;
}

torus_Extrema torus_extrema(torus_Line line) {
    TORUS_PRECISE float n = line.direction.x * line.direction.x + line.direction.y * line.direction.y;
    TORUS_PRECISE float m = line.foot.x * line.direction.x + line.foot.y * line.direction.y;
    TORUS_PRECISE float rho2 = line.foot.x * line.foot.x + line.foot.y * line.foot.y;
    // Mirror the line so that it passes the axis at c >= 0.
    TORUS_PRECISE float mirror = m > 0.0 ? -1.0 : 1.0;
    m = -abs(m);
    TORUS_PRECISE float R = line.majorRadius;
    // R rho'' rho^3 = R (n rho^2 - s^2) is the same everywhere on a line: the square of its moment about the axis.
    TORUS_PRECISE float moment = line.foot.x * line.direction.y - line.foot.y * line.direction.x;
    TORUS_PRECISE float moment2 = moment * moment;
    TORUS_PRECISE float turn = R * moment2;
    TORUS_PRECISE float c = n > 0.0 ? -m / n : 0.0;
    TORUS_PRECISE float nearest2 = n > 0.0 ? moment2 / n : 0.0;
    TORUS_PRECISE float dd = line.length2;
    TORUS_PRECISE float reach = R * sqrt(n) / dd;
    TORUS_PRECISE float left = -reach;
    TORUS_PRECISE float right = reach;
    TORUS_PRECISE float middle = c;
    bool hasRight = reach > c;
    TORUS_PRECISE float leftFlatness = 1.0;
    TORUS_PRECISE float rightFlatness = 1.0;
    TORUS_PRECISE float middleFlatness = -1.0;
    TORUS_PRECISE float enough = TORUS_EXTREMUM_STEP * line.minorRadius;
    bool busy = true;
    for (int i = 0; i < TORUS_EXTREMUM_STEPS && busy; ++i) {
        TORUS_ON_STEP
        // g / g' = (dd u rho - R s) rho^2 / (dd rho^3 - R rho'' rho^3), s = rho rho' = n u + m
        TORUS_PRECISE float sLeft = n * left + m;
        TORUS_PRECISE float square = max((sLeft + m) * left + rho2, 1.0e-20);
        TORUS_PRECISE float rho = sqrt(square);
        TORUS_PRECISE float cube = rho * square;
        TORUS_PRECISE float bend = dd * cube - turn;
        TORUS_PRECISE float perBend = 1.0 / max(bend, 1.0e-20);
        TORUS_PRECISE float step = (R * sLeft - dd * left * rho) * square * perBend;
        step = clamp(step, 0.0, c - left);
        left = left + step;
        leftFlatness = cube * perBend;
        busy = step > enough;

        TORUS_PRECISE float sRight = n * right + m;
        square = max((sRight + m) * right + rho2, 1.0e-20);
        rho = sqrt(square);
        cube = rho * square;
        bend = dd * cube - turn;
        hasRight = hasRight && bend > 0.0 && right > c;
        perBend = 1.0 / max(bend, 1.0e-20);
        step = hasRight ? (dd * right * rho - R * sRight) * square * perBend : 0.0;
        right = right - max(step, 0.0);
        rightFlatness = cube * perBend;
        busy = busy || step > enough;

        // The maximum, from c, monotone. In terms of q = u - c, in which rho^2 = (moment^2 + (n q)^2) / n and
        // rho rho' = n q: near the axis these agree with each other, where differences of larger numbers would be all
        // rounding.
        TORUS_PRECISE float q = middle - c;
        TORUS_PRECISE float sMiddle = n * q;
        square = nearest2 + sMiddle * q;
        rho = sqrt(square);
        cube = rho * square;
        bend = dd * cube - turn;
        // Without a bend the line passes through the axis, and here is the edge that G has there.
        bool edge = bend > -1.0e-30;
        perBend = edge ? 0.0 : 1.0 / bend;
        step = (R * sMiddle - dd * middle * rho) * square * perBend;
        middleFlatness = edge ? -1.0e-20 : cube * perBend;
        TORUS_PRECISE float next = clamp(middle + step, left, max(left, right));
        TORUS_PRECISE float change = next - middle;
        middle = next;
        busy = busy || (hasRight && abs(change) > enough);
    }
    hasRight = hasRight && right > c;
    right = hasRight ? right : left;
    rightFlatness = hasRight ? rightFlatness : leftFlatness;

    TORUS_PRECISE float leftAt = mirror * left;
    TORUS_PRECISE float rightAt = mirror * right;
    TORUS_PRECISE float middleAt = mirror * middle;
    float leftSlope;
    float rightSlope;
    float middleSlope;
    float leftValue = torus_tube(line, leftAt, leftSlope);
    float rightValue = torus_tube(line, rightAt, rightSlope);
    float middleValue = torus_tube(line, middleAt, middleSlope);
    bool leftBusy = torus_doubtful(line, leftValue, leftSlope, leftFlatness);
    bool rightBusy = hasRight && torus_doubtful(line, rightValue, rightSlope, rightFlatness);
    bool middleBusy = hasRight && torus_doubtful(line, middleValue, middleSlope, middleFlatness);
    // One loop for all: drivers that run the untaken side of branches run the long exact step but once, and code that is
    // seldom run is short.
    int steps = 0;
    for (int i = 0; i < 3 * TORUS_SETTLE_STEPS && (leftBusy || rightBusy || middleBusy); ++i) {
        TORUS_ON_STEP
        bool atLeft = leftBusy;
        bool atRight = !leftBusy && rightBusy;
        bool atMiddle = !leftBusy && !rightBusy;
        float at = atLeft ? leftAt : (atRight ? rightAt : middleAt);
        float flatness = atLeft ? leftFlatness : (atRight ? rightFlatness : middleFlatness);
        float value = 0.0;
        ++steps;
        bool again = torus_settle(line, flatness, steps == TORUS_SETTLE_STEPS, at, value);
        steps = again ? steps : 0;
        leftBusy = leftBusy && again;
        rightBusy = rightBusy && (atLeft || again);
        middleBusy = middleBusy && (!atMiddle || again);
        leftAt = atLeft ? at : leftAt;
        leftValue = atLeft ? value : leftValue;
        rightAt = atRight ? at : rightAt;
        rightValue = atRight ? value : rightValue;
        middleAt = atMiddle ? at : middleAt;
        middleValue = atMiddle ? value : middleValue;
    }
    rightAt = hasRight ? rightAt : leftAt;
    rightValue = hasRight ? rightValue : leftValue;
    torus_Extrema extrema;
    bool mirrored = mirror < 0.0;
    extrema.hasSecond = hasRight;
    extrema.firstMinimum = mirrored ? rightAt : leftAt;
    extrema.firstValue = mirrored ? rightValue : leftValue;
    extrema.firstFlatness = mirrored ? rightFlatness : leftFlatness;
    extrema.secondMinimum = mirrored ? leftAt : rightAt;
    extrema.secondValue = mirrored ? leftValue : rightValue;
    extrema.secondFlatness = mirrored ? leftFlatness : rightFlatness;
    // A maximum that is not between the minima is none: a pair of extrema has merged, and Newton was left with a place
    // where G is merely flat.
    extrema.isBetween = middleAt > extrema.firstMinimum && middleAt < extrema.secondMinimum;
    extrema.middle = middleAt;
    extrema.middleValue = extrema.isBetween ? middleValue : max(leftValue, rightValue);
    return extrema;
}

// The root of G in [lower, upper], where G changes sign; `rising` says whether it goes from inside to outside. A start
// outside the bracket is replaced by its middle.
float torus_root(torus_Line line, float lower, float upper, bool rising, float start, bool wanted) {
    TORUS_PRECISE float lo = lower;
    TORUS_PRECISE float hi = upper;
    TORUS_PRECISE float u = start > lo && start < hi ? start : 0.5 * (lo + hi);
    TORUS_PRECISE float enough = TORUS_ROOT_STEP * line.minorRadius;
    TORUS_PRECISE float noise = TORUS_ROOT_VALUE * line.minorRadius * (line.majorRadius + line.minorRadius);
    bool busy = wanted;
    for (int i = 0; i < TORUS_ROOT_STEPS && busy; ++i) {
        TORUS_ON_STEP
        float slope;
        TORUS_PRECISE float value = torus_tube(line, u, slope);
        bool tooFar = rising == (value > 0.0);
        lo = tooFar ? lo : u;
        hi = tooFar ? u : hi;
        TORUS_PRECISE float next = u - 0.5 * value / slope;
        bool trusted = next >= lo && next <= hi;
        next = trusted ? next : 0.5 * (lo + hi);
        TORUS_PRECISE float change = next - u;
        bool longStep = abs(change) > enough;
        bool quiet = abs(value) <= noise;
        busy = longStep && !quiet;
        // Where G is but its rounding, a long step goes anywhere.
        u = longStep && quiet ? u : next;
    }
    return u;
}

#endif
