// SPDX-License-Identifier: MIT
// Private: the last step, which makes a crossing of the surface that a line is known to have near some u exact: to the
// root of the parabola that has the tube function's exact value, slope and curvature there (math.md, eq. 27), kept apart
// from u, so that position and t are right to the rounding of the result, tangents included.
#ifndef TORUS_LAST_STEP_GLSL
#define TORUS_LAST_STEP_GLSL

#include "tube.glsl"

// Exact last steps to a root: one, and more where it is longer than this part of the slope, or where the third
// derivative, which the parabola leaves out, moves the root by more than half this much. Where G is as flat as a cubic
// (its extrema have just merged, on the surface) each halves the distance, until it is below the rounding of the hit.
#define TORUS_LAST_STEPS 24
#define TORUS_LONG_STEP 0.01
#define TORUS_THIRD_ORDER 7.450580597e-9
#define TORUS_LAST_STEP 9.313225746e-10
// What is known to some 2^-31 of a unit is enough for a crossing that is not nearer to the axis than this, its t not
// nearer to 0 in units, and the sine of the angle at which the line meets the surface, squared, not less than this: a
// smaller one would magnify roundings.
#define TORUS_CLEAR_RHO 0.03125
#define TORUS_CLEAR_T 0.0625
#define TORUS_CLEAR_SINE2 0.00390625
// The series for the parabola's root ends with its fourth term: the fifth is 7/128 of the fourth power of this.
#define TORUS_CLEAR_SERIES 0.015625

struct torus_End {
    vec3 position;  // in units
    float shift;    // from the line's base, in lengths of the direction ...
    float rest;     // ... and what is left of that
    float u;        // the sum of both, from the line's foot
    bool right;     // false: not clear enough
};

// The last step of a clear crossing, as nearly all are: by two thirds of the work, and by a shorter chain from one result
// to the next. Numbers are split at a fixed place, not each at its own middle bit: sums of high parts then have no
// rounding that had to be found out, and neither have their squares. A coordinate's high part is a multiple of 2^-10
// below 4, its square one of 2^-20 below 16. docs/accuracy.md, "The bound", has what the low parts lose.
torus_End torus_clearStep(torus_Line line, float u, bool rising) {
    TORUS_PRECISE vec3 d = line.direction;
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE float shift = line.shift + u;
    TORUS_PRECISE float shiftLow = u - (shift - line.shift);
    // base + shift * direction. `sum` is exact: base and shift are less than 16 (line.glsl), the direction less than 2, so
    // all of it are multiples of 2^-19 below 32.
    TORUS_PRECISE float coarse = torus_rounded(shift, TORUS_TO_8_BITS);
    TORUS_PRECISE float fine = (shift - coarse) + shiftLow;
    TORUS_PRECISE vec3 dHigh = torus_rounded3(d, TORUS_TO_11_BITS);
    TORUS_PRECISE vec3 dLow = d - dHigh;
    TORUS_PRECISE vec3 baseHigh = torus_rounded3(line.base, TORUS_TO_19_BITS);
    TORUS_PRECISE vec3 baseLow = (line.base - baseHigh) + line.baseLow;
    TORUS_PRECISE vec3 sum = baseHigh + coarse * dHigh;
    TORUS_PRECISE vec3 rest = coarse * dLow + (baseLow + fine * d);
    TORUS_PRECISE vec3 high = torus_rounded3(sum + rest, TORUS_TO_10_BITS);
    TORUS_PRECISE vec3 low = (sum - high) + rest;
    // (high + low)^2 = high^2 + more
    TORUS_PRECISE vec3 more = low * (2.0 * high + low);
    // rho = root, and more exactly rootHigh + rootLow: one Newton step on the residual of the rounded root.
    TORUS_PRECISE float rhoHigh2 = high.x * high.x + high.y * high.y;
    TORUS_PRECISE float rhoMore = more.x + more.y;
    TORUS_PRECISE float root = sqrt(rhoHigh2 + rhoMore);
    TORUS_PRECISE float perRoot = 1.0 / max(root, TORUS_CLEAR_RHO);
    TORUS_PRECISE float rootHigh = torus_rounded(root, TORUS_TO_10_BITS);
    TORUS_PRECISE float rootRest = root - rootHigh;
    TORUS_PRECISE float residual =
        ((rhoHigh2 - rootHigh * rootHigh) - rootRest * (rootHigh + root)) + rhoMore;
    TORUS_PRECISE float rootLow = rootRest + residual * (0.5 * perRoot);
    // G = q^2 + z^2 - r^2, q = rho - R
    TORUS_PRECISE float majorHigh = torus_rounded(R, TORUS_TO_10_BITS);
    TORUS_PRECISE float minorHigh = torus_rounded(r, TORUS_TO_10_BITS);
    TORUS_PRECISE float minorLow = r - minorHigh;
    TORUS_PRECISE float qHigh = rootHigh - majorHigh;
    TORUS_PRECISE float qLow = rootLow - (R - majorHigh);
    TORUS_PRECISE float tubeHigh = (qHigh * qHigh + high.z * high.z) - minorHigh * minorHigh;
    TORUS_PRECISE float tubeMore = (qLow * (2.0 * qHigh + qLow) + more.z) - minorLow * (2.0 * minorHigh + minorLow);
    TORUS_PRECISE float tube = tubeHigh + tubeMore;
    // None of this waits for the tube, nor does the division by the slope.
    TORUS_PRECISE vec3 point = high + low;
    torus_Slopes slopes = torus_slopes(line, point, perRoot);
    TORUS_PRECISE float halfSlope = slopes.halfSlope;
    TORUS_PRECISE float leastSlope2 = TORUS_CLEAR_SINE2 * (r * r * line.length2);
    bool steep = halfSlope * halfSlope >= leastSlope2;
    TORUS_PRECISE float perSlope = 1.0 / (steep ? halfSlope : 1.0);
    TORUS_PRECISE float flatness = slopes.halfCurvature * perSlope * perSlope;
    // The parabola's root is 2 / (1 + sqrt(1 - e)) = 1 + e / 4 + e^2 / 8 + 5 e^3 / 64 + ... times that of the tangent.
    TORUS_PRECISE float e = flatness * tube;
    TORUS_PRECISE float tangent = -0.5 * perSlope * tube;
    TORUS_PRECISE float step = tangent + tangent * (e * (0.25 + e * (0.125 + 0.078125 * e)));
    TORUS_PRECISE float t = line.baseShift + shift;
    TORUS_PRECISE float longStep = TORUS_LONG_STEP * abs(halfSlope);
    TORUS_PRECISE float thirdOrder = slopes.sixthThird * step * step * step;
    TORUS_PRECISE float smallOrder = TORUS_THIRD_ORDER * abs(halfSlope) * min(abs(t), 1.0);
    bool right = steep && rising == (halfSlope > 0.0) && root >= TORUS_CLEAR_RHO && abs(t) >= TORUS_CLEAR_T &&
                 abs(e) <= TORUS_CLEAR_SERIES && abs(step) <= longStep && abs(thirdOrder) <= smallOrder;
    TORUS_PRECISE vec3 position = high + (low + step * d);
    TORUS_PRECISE float exactRest = shiftLow + step;
    TORUS_PRECISE float exactU = u + step;
    return torus_End(position, shift, exactRest, exactU, right);
}

// The last steps of any crossing. `rising`: where the line leaves the solid, else where it enters it. `outer`: the solid
// has no crossing beyond it.
torus_End torus_exactSteps(torus_Line line, float u, bool rising, bool outer) {
    TORUS_PRECISE float at = u;
    TORUS_PRECISE float shift = 0.0;
    TORUS_PRECISE float rest = 0.0;
    TORUS_PRECISE vec3 position = vec3(0.0, 0.0, 0.0);
    bool again = true;
    for (int i = 0; i < TORUS_LAST_STEPS && again; ++i) {
        TORUS_ON_STEP
        torus_Point point = torus_exactPoint(line, at);
        TORUS_PRECISE float slope = rising ? point.halfSlope : -point.halfSlope;
        TORUS_PRECISE float discriminant = slope * slope - point.halfCurvature * point.tube;
        // Of the parabola's roots the one where it has this crossing's slope, in the form that does not cancel. The
        // second form crosses an extremum. Where there is no root outside, it leads to the extremum itself: the line just
        // misses, and both hits of that tangent are where it comes closest. Where there is none ahead inside, at a
        // maximum between two dips so shallow that the search could not tell them apart, it goes on beyond that.
        bool goesOn = outer && point.tube < 0.0 && point.halfCurvature < 0.0 && (slope < 0.0 || discriminant < 0.0);
        TORUS_PRECISE float radicand = goesOn ? abs(discriminant) : max(discriminant, 0.0);
        TORUS_PRECISE float root = sqrt(radicand);
        bool direct = (slope >= 0.0 && discriminant >= 0.0) || point.halfCurvature == 0.0;
        TORUS_PRECISE float across = goesOn ? -root - abs(slope) : root - slope;
        TORUS_PRECISE float numerator = direct ? -point.tube : across;
        TORUS_PRECISE float denominator = direct ? slope + root : point.halfCurvature;
        TORUS_PRECISE float forwards = denominator != 0.0 ? numerator / denominator : 0.0;
        TORUS_PRECISE float step = rising ? forwards : -forwards;
        // The slope is known to some 2^-24, and the step to as much over the slope: a long step along a flat
        // crossing, as of a ray nearly along a thin tube, needs another one. So does a step near the axis, where rho
        // turns sharply: at the tip of a horn.
        TORUS_PRECISE float longStep = TORUS_LONG_STEP * abs(slope);
        TORUS_PRECISE float thirdOrder = point.sixthThird * step * step * step;
        // The closer to the origin, the more digits t has.
        TORUS_PRECISE float t = line.baseShift + point.shift;
        TORUS_PRECISE float smallOrder = TORUS_THIRD_ORDER * root * min(abs(t), 1.0);
        again = abs(step) > TORUS_LAST_STEP && (abs(step) > longStep || abs(thirdOrder) > smallOrder);
        TORUS_PRECISE vec3 exactPosition = point.high + (point.low + step * line.direction);
        TORUS_PRECISE float exactRest = point.shiftLow + step;
        TORUS_PRECISE float next = at + step;
        position = exactPosition;
        shift = point.shift;
        rest = exactRest;
        at = next;
    }
    return torus_End(position, shift, rest, at, true);
}

// The same, of a crossing that is to be tried as a `clear` one.
torus_End torus_lastStep(torus_Line line, float u, bool rising, bool outer, bool clear) {
    torus_End end = torus_End(vec3(0.0, 0.0, 0.0), 0.0, 0.0, 0.0, false);
    if (clear) {
        end = torus_clearStep(line, u, rising);
    }
    if (!end.right) {
        end = torus_exactSteps(line, u, rising, outer);
    }
    return end;
}

#endif
