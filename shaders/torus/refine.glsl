// SPDX-License-Identifier: MIT
// Private: the refinement, which makes a crossing exact that the march is near, or finds that there is none.
//
// It rests on the tube function, the squared distance from the tube's centre circle less r^2, which knows no inner sheet
// (math.md, eq. 24 to 27):
//
//     G(p) = (rho - R)^2 + z^2 - r^2,    rho = |(x, y)|,    f = G (G + 4 R rho) / dd^2
//
// The point and G are evaluated as sums of two floats. The crossing is the root of the parabola with the value, slope and
// curvature of G, and is kept apart from u, so that position and t are right to the rounding of the result.
#ifndef TORUS_REFINE_GLSL
#define TORUS_REFINE_GLSL

#include "crossing.glsl"

// The parabola is good for steps up to this part of the half slope over r, in which the slope's rounding moves the root by
// less than a sixteenth of the rounding of a position: the slope is known to some 2^-22 r.
#define TORUS_LONG_STEP 0.015625
// ... and up to where the third and fourth derivatives, which it leaves out, move the root by more than this, in units; of
// a t below one unit by this part of t, for t has more digits there, but for those below a sixteenth.
#define TORUS_THIRD_ORDER 7.450580597e-9
#define TORUS_SHORT_T 0.0625
// ... and only on this side of the axis, at which rho has an edge.
#define TORUS_AXIS_STEP 0.25
// A repeated refinement takes steps up to where these derivatives are this part of the slope.
#define TORUS_LARGE_ORDER 0.125
// A step that does not matter, in units; at a horn's tip G underflows before it is all rounding. And a small one, if it
// only follows the rounding of G, in r over the half slope.
#define TORUS_TINY_STEP 9.313225746e-10
#define TORUS_SMALL_STEP 1.0e-6
#define TORUS_TINY_VALUE 5.9604644775e-14

// A point of the line, as the sum of two floats, and the tube function there.
struct torus_Point {
    vec3 high;
    vec3 low;
    float shift;       // from the line's base, in lengths of the direction ...
    float shiftLow;    // ... and what is left of that
    float rho;
    float q;           // rho - R
    float tube;        // G: near the surface to some 2^-45 of r (R + r)
    float along;       // the point times the direction: of the components across the axis ...
    float rise;        // ... and of that along it
    float halfSlope;   // G' / 2
    float bend;        // |direction|^2 - G'' / 2
    float sixthThird;  // G''' / 6: all of it is the bend of rho, which is sharp near the axis
    float fourth;      // 4 G'''' / 24 where the line is nearest to the axis, and G''' is 0; less elsewhere
};

torus_Point torus_pointAt(const torus_Line line, float u) {
    TORUS_PRECISE vec3 d = line.direction;
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    // Any two floats that make up a place near u will do, as long as t is made of the same two.
    TORUS_PRECISE float shift = line.shift + u;
    TORUS_PRECISE float shiftLow = u - (shift - line.shift);
    vec3 low;
    vec3 p = torus_advance3(line.base, line.baseLow, shift, shiftLow, d, low);
    // rho by its rounded root, and one Newton step on that root's exact residual.
    TORUS_PRECISE float rho = sqrt(p.x * p.x + p.y * p.y);
    TORUS_PRECISE float invRho = 1.0 / max(rho, TORUS_AXIS);
    TORUS_PRECISE float residual = torus_squareDifference(p.x, p.y, rho) + 2.0 * (p.x * low.x + p.y * low.y);
    // In a thin tube q is so small that the square of its low part counts.
    TORUS_PRECISE float qHigh = rho - R;
    TORUS_PRECISE float qLow = torus_twoSumError(rho, -R, qHigh) + 0.5 * residual * invRho;
    TORUS_PRECISE float tube =
        torus_squareDifference(qHigh, p.z, r) + ((2.0 * qHigh + qLow) * qLow + 2.0 * (p.z * low.z));
    TORUS_PRECISE float q = qHigh + qLow;
    // The curvature by Lagrange's identity, which keeps its digits near the axis.
    TORUS_PRECISE float along = p.x * d.x + p.y * d.y;
    TORUS_PRECISE float rise = p.z * d.z;
    TORUS_PRECISE float rhoSlope = along * invRho;
    TORUS_PRECISE float halfSlope = rhoSlope * q + rise;
    TORUS_PRECISE float across = (p.x * d.y - p.y * d.x) * invRho;
    TORUS_PRECISE float rhoBend = (across * across) * invRho;
    TORUS_PRECISE float bend = R * rhoBend;
    TORUS_PRECISE float bendPerRho = bend * invRho;
    TORUS_PRECISE float sixthThird = bendPerRho * rhoSlope;
    TORUS_PRECISE float fourth = bendPerRho * rhoBend;
    return torus_Point(p, low, shift, shiftLow, rho, q, tube, along, rise, halfSlope, bend, sixthThird, fourth);
}

// f and half its slope at the point, which G makes exact.
void torus_tellMarch(const torus_Line line, const torus_Point point, inout torus_March march) {
    TORUS_PRECISE float invDd2 = line.invLength2 * line.invLength2;
    TORUS_PRECISE float twoR = 2.0 * line.majorRadius;
    TORUS_PRECISE float middle = point.tube + twoR * point.rho;
    TORUS_PRECISE float a = point.tube + twoR * point.q;
    TORUS_PRECISE float f = point.tube * (middle + twoR * point.rho) * invDd2;
    TORUS_PRECISE float h = 2.0 * (a * point.along + middle * point.rise) * invDd2;
    march.f = f;
    march.h = h;
}

// Refines where the march is. It goes on from there, on the other side of a crossing.
torus_Crossing torus_refine(const torus_Line line, inout torus_March march) {
    TORUS_ON_REFINEMENT
    float r = line.minorRadius;
    torus_Point point = torus_pointAt(line, march.u);
    march.side = march.side == 0.0 ? (point.tube < 0.0 ? -1.0 : 1.0) : march.side;
    // The parabola g + 2 s x + C x^2. Of its roots the one where it falls.
    TORUS_PRECISE float g = march.side * point.tube;
    TORUS_PRECISE float s = march.side * point.halfSlope;
    TORUS_PRECISE float C = march.side * (line.length2 - point.bend);
    TORUS_PRECISE float discriminant = s * s - C * g;
    TORUS_PRECISE float root = sqrt(max(discriminant, 0.0));
    bool nears = s <= 0.0;
    TORUS_PRECISE float numerator = nears ? g : root + s;
    TORUS_PRECISE float denominator = nears ? root - s : -C;
    TORUS_PRECISE float x = denominator != 0.0 ? numerator / denominator : 0.0;
    // Whether the parabola is good for so long a step.
    TORUS_PRECISE float size = abs(x);
    TORUS_PRECISE float toAxis = size * abs(point.along);
    TORUS_PRECISE float nearAxis = TORUS_AXIS_STEP * (point.rho * point.rho);
    TORUS_PRECISE float value = size * max(root, abs(s));
    TORUS_PRECISE float tinyValue = TORUS_TINY_VALUE * r;
    bool tiny = size <= TORUS_TINY_STEP || (size <= TORUS_SMALL_STEP && value <= tinyValue);
    bool beside = toAxis <= nearAxis;
    // A step past the edge that rho has at the axis leads nowhere: the point itself is the crossing, if G is its rounding.
    bool edge = !beside && (tiny || (abs(g) <= tinyValue && point.rho <= TORUS_SMALL_STEP));
    x = edge ? 0.0 : x;
    TORUS_PRECISE float rest = point.shiftLow + x;
    TORUS_PRECISE float t = (line.baseShift + point.shift) + rest;
    TORUS_PRECISE float order = (abs(point.sixthThird) + size * point.fourth) * (size * size * size);
    TORUS_PRECISE float smallOrder = TORUS_THIRD_ORDER * root * clamp(abs(t), TORUS_SHORT_T, 1.0);
    TORUS_PRECISE float relativeSize = size * (r * line.length2);
    TORUS_PRECISE float longStep = TORUS_LONG_STEP * abs(s);
    bool good = tiny || edge || march.known || (order <= smallOrder && relativeSize <= longStep && beside);
    TORUS_PRECISE float crossing = march.u + x;
    // From past a dip's extremum the parabola's falling root is behind: of a dip that the march has passed by rounding, or
    // of one that it has found. A parabola that opens downwards and has no root touches: what has entered there leaves there.
    bool ahead = nears || C < 0.0 || g < 0.0 || (C > 0.0 && crossing >= march.from);
    bool touches = C < 0.0 && g < 0.0;
    bool exists = (discriminant >= 0.0 && ahead) || touches;
    bool found = exists && good;
    // Where the parabola is good and has no root, the line passes the surface by, and the march goes on behind the extremum.
    bool passes = !exists && good && nears && x > 0.0;
    // A longer step may still lead nearer, and to another refinement.
    TORUS_PRECISE float largeOrder = TORUS_LARGE_ORDER * value;
    TORUS_PRECISE float lastStep = TORUS_LAST_STEP * r;
    bool repeats = exists && !good && beside && order <= largeOrder && size <= lastStep;
    TORUS_PRECISE vec3 position = point.high + (point.low + x * line.direction);
    TORUS_PRECISE float beyond = crossing + TORUS_CLEARANCE;
    TORUS_PRECISE float behind = crossing + x;
    march.u = found ? beyond : (repeats ? crossing : (passes ? behind : march.u));
    march.from = found ? beyond : (passes ? behind : march.from);
    march.side = found ? -march.side : march.side;
    march.reach = found ? torus_firstReach(line, march.side) : march.reach;
    march.refines = repeats;
    march.known = !found && !repeats && !passes;
    // What decides nothing here decides the next step.
    if (march.known) {
        torus_tellMarch(line, point, march);
    }
    return torus_Crossing(found, position, point.shift, rest);
}

// The next crossing.
torus_Crossing torus_nextCrossing(const torus_Line line, const torus_Quartic quartic, inout torus_March march) {
    torus_Crossing crossing = torus_noCrossing();
    bool busy = true;
    for (int i = 0; i < TORUS_PASSES && busy; ++i) {
        torus_search(quartic, line.upper, TORUS_PASS_STEPS, march);
        if (march.refines) {
            crossing = torus_refine(line, march);
        }
        busy = march.searching && !crossing.found;
    }
    return crossing;
}

// Whether there is a crossing before the ray's end. Of one that is certain the place is not needed.
bool torus_crosses(const torus_Line line, const torus_Quartic quartic, inout torus_March march) {
    bool crosses = false;
    bool busy = true;
    for (int i = 0; i < TORUS_PASSES && busy; ++i) {
        torus_search(quartic, line.upper, TORUS_PASS_STEPS, march);
        bool found = march.certain;
        crosses = march.certain;
        if (march.refines && !march.certain) {
            torus_Crossing crossing = torus_refine(line, march);
            found = crossing.found;
            crosses = crossing.found && torus_isWithin(line, crossing);
        }
        busy = march.searching && !found;
    }
    return crosses;
}

#endif
