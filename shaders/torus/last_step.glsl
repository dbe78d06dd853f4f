// SPDX-License-Identifier: MIT
// Private: the last step, which makes a crossing of the surface that a line is known to have near some u exact: to the
// root of the parabola that has the tube function's exact value, slope and curvature there (math.md, eq. 27), kept apart
// from u, so that position and t are right to the rounding of the result, tangents included.
#ifndef TORUS_LAST_STEP_GLSL
#define TORUS_LAST_STEP_GLSL

#include "quartic.glsl"
#include "tube.glsl"

// Exact last steps to a root: one, and more where it is longer than this part of the slope, or where the third
// derivative, which the parabola leaves out, moves the root by more than half this much. Where G is as flat as a cubic
// (its extrema have just merged, on the surface) each halves the distance, until it is below the rounding of the hit.
#define TORUS_LAST_STEPS 24
#define TORUS_LONG_STEP 0.01
#define TORUS_THIRD_ORDER 7.450580597e-9
#define TORUS_LAST_STEP 9.313225746e-10
// What is known to some 2^-31 of a unit is enough for a crossing whose t is not nearer to 0 than this, in units, which is
// not nearer to the axis than this part of R, and where the sine of the angle at which the line meets the surface, squared,
// is not less than this: smaller ones would magnify roundings.
#define TORUS_CLEAR_T 0.0625
#define TORUS_CLEAR_RHO 0.25
#define TORUS_CLEAR_SINE2 0.00390625
// The series for the parabola's root ends with its third term: the fourth is 5/64 of the third power of this.
#define TORUS_CLEAR_SERIES 0.015625

struct torus_End {
    vec3 position;  // in units
    float shift;    // from the line's base, in lengths of the direction ...
    float rest;     // ... and what is left of that
    bool right;     // false: not clear enough
};

// The last step of a clear crossing, as nearly all are: to the root of the parabola not of G but of the quartic
// (quartic.glsl), which loses no tube either when it is evaluated from the point, and needs no square root for that,
//
//     f(p) = a^2 - 4 R^2 b,    a = |p|^2 - R^2 - r^2,    b = r^2 - z^2.
//
// Numbers are split at a fixed place, not each at its own middle bit: sums of high parts then have no rounding that had
// to be found out, and neither have their squares. A coordinate's high part is a multiple of 2^-10 below 4, its square
// one of 2^-20 below 16. docs/accuracy.md, "The bound", has what the low parts lose.
torus_End torus_clearStep(torus_Line line, torus_Quartic quartic, float u, bool rising) {
    TORUS_PRECISE vec3 d = line.direction;
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE float shift = line.shift + u;
    TORUS_PRECISE float shiftLow = u - (shift - line.shift);
    // base + shift * direction = high + low. The shift is less than 16 (line.glsl), the direction less than 2: the product
    // of their high parts is exact, and a multiple of 2^-19 below 32, from which `high` is subtracted exactly.
    TORUS_PRECISE float coarse = torus_rounded(shift, TORUS_TO_8_BITS);
    TORUS_PRECISE float fine = shift - coarse;
    TORUS_PRECISE vec3 dHigh = torus_rounded3(d, TORUS_TO_11_BITS);
    TORUS_PRECISE vec3 dLow = d - dHigh;
    TORUS_PRECISE vec3 moved = coarse * dHigh;
    TORUS_PRECISE vec3 movedLow = coarse * dLow + fine * d;
    TORUS_PRECISE vec3 high = torus_rounded3((line.base + moved) + movedLow, TORUS_TO_10_BITS);
    TORUS_PRECISE vec3 low = (((moved - high) + line.base) + movedLow) + (line.baseLow + shiftLow * d);
    // (high + low)^2 = high^2 + more
    TORUS_PRECISE vec3 more = low * (high + (high + low));
    // R^2, r^2 and 4 R^2 in the same way.
    TORUS_PRECISE float majorHigh = torus_rounded(R, TORUS_TO_10_BITS);
    TORUS_PRECISE float major2High = majorHigh * majorHigh;
    TORUS_PRECISE float major2Low = (R - majorHigh) * (majorHigh + R);
    TORUS_PRECISE float minorHigh = torus_rounded(r, TORUS_TO_10_BITS);
    TORUS_PRECISE float minor2High = minorHigh * minorHigh;
    TORUS_PRECISE float minor2Low = (r - minorHigh) * (minorHigh + r);
    TORUS_PRECISE float scale = 4.0 * (major2High + major2Low);
    TORUS_PRECISE float scaleHigh = torus_upperHalf(scale);
    TORUS_PRECISE float scaleLow = (4.0 * major2High - scaleHigh) + 4.0 * major2Low;
    TORUS_PRECISE float z2High = high.z * high.z;
    TORUS_PRECISE float aSum = ((high.x * high.x + high.y * high.y) + z2High) - (major2High + minor2High);
    TORUS_PRECISE float aRest = (more.x + more.y) + (more.z - (major2Low + minor2Low));
    TORUS_PRECISE float a = aSum + aRest;
    TORUS_PRECISE float aHigh = torus_upperHalf(a);
    TORUS_PRECISE float aLow = (aSum - aHigh) + aRest;
    TORUS_PRECISE float bSum = minor2High - z2High;
    TORUS_PRECISE float bRest = minor2Low - more.z;
    TORUS_PRECISE float b = bSum + bRest;
    TORUS_PRECISE float bHigh = torus_upperHalf(b);
    TORUS_PRECISE float bLow = (bSum - bHigh) + bRest;
    TORUS_PRECISE float exact = (aHigh * aHigh - scaleHigh * bHigh) +
                                (aLow * (aHigh + a) - (scaleHigh * bLow + scaleLow * b));
    TORUS_PRECISE float perDd = line.perLength2;
    TORUS_PRECISE float f = exact * (perDd * perDd);
    // Slope and bend are the search's own, so that nothing of this waits for f, nor does the division. Without a slope it
    // gives nothing that is right.
    torus_Value at = torus_quarticAt(quartic, quartic.b1, u);
    TORUS_PRECISE float slope = rising ? at.slope : -at.slope;
    TORUS_PRECISE float perSlope = 1.0 / slope;
    TORUS_PRECISE float halfBend = 6.0 * (u * u + quartic.bend);
    // f = G (G + 4 R rho) / dd^2: by 4 R rho / dd^2 its slope is longer than that of G.
    TORUS_PRECISE float ring = scale * perDd;
    TORUS_PRECISE float tube = 2.0 * at.a + ring;
    TORUS_PRECISE float leastTube = TORUS_CLEAR_RHO * ring;
    TORUS_PRECISE float longer = tube * perDd;
    TORUS_PRECISE float least = r * longer;
    TORUS_PRECISE float leastSlope2 = 4.0 * TORUS_CLEAR_SINE2 * (least * least * line.length2);
    // The parabola's root is 2 / (1 + sqrt(1 - e)) = 1 + e / 4 + e^2 / 8 + ... times that of the tangent.
    TORUS_PRECISE float quarterE = halfBend * perSlope * perSlope * f;
    TORUS_PRECISE float tangent = -perSlope * f;
    TORUS_PRECISE float forwards = tangent + (tangent * quarterE) * (1.0 + 2.0 * quarterE);
    TORUS_PRECISE float step = rising ? forwards : -forwards;
    TORUS_PRECISE float t = line.baseShift + shift;
    TORUS_PRECISE float longStep = 0.5 * TORUS_LONG_STEP * slope;
    TORUS_PRECISE float thirdOrder = 8.0 * u * tangent * tangent * tangent;
    TORUS_PRECISE float smallOrder = 0.5 * TORUS_THIRD_ORDER * slope * min(abs(t), 1.0);
    TORUS_PRECISE float slope2 = slope * slope;
    TORUS_PRECISE float halfWay = abs(tangent) * longer;
    bool right = slope2 >= leastSlope2 && slope > 0.0 && tube >= leastTube && abs(t) >= TORUS_CLEAR_T &&
                 abs(quarterE) <= 0.25 * TORUS_CLEAR_SERIES && halfWay <= longStep && abs(thirdOrder) <= smallOrder;
    TORUS_PRECISE vec3 position = high + (low + step * d);
    TORUS_PRECISE float exactRest = shiftLow + step;
    return torus_End(position, shift, exactRest, right);
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
    return torus_End(position, shift, rest, true);
}

// The same, of a crossing that is to be tried as a `clear` one, as none is of a horn or a spindle.
torus_End torus_lastStep(torus_Line line, torus_Quartic quartic, float u, bool rising, bool outer, bool clear) {
    torus_End end = torus_End(vec3(0.0, 0.0, 0.0), 0.0, 0.0, false);
    TORUS_PRECISE float ring = TORUS_RING * line.majorRadius;
    if (clear && line.minorRadius <= ring) {
        end = torus_clearStep(line, quartic, u, rising);
    }
    if (!end.right) {
        end = torus_exactSteps(line, u, rising, outer);
    }
    return end;
}

#endif
