// SPDX-License-Identifier: MIT
// Private: a filter before the exact solver. It finds the first crossing of nearly every ray that starts outside a ring,
// or proves that there is none, with a tenth of the work, and says of every other ray that it does not know.
//
// A point p of the torus has |p|^2 - R^2 - r^2 = +-2 R sqrt(r^2 - z^2). Along the line, where |p|^2 = dd u^2 + |foot|^2,
// that is a zero of
//
//     f(u) = a^2 + 4 R^2 (z - r) (z + r),    a = dd u^2 + k,    k = |foot|^2 - R^2 - r^2    (math.md, eq. 28)
//
// which is negative inside a ring, has no root in it, and loses no thin tube to its coefficients: near the surface both
// terms are of the size of R^2 r^2.
//
// f'' is zero at -w and w: f is convex left of -w, concave between them, convex right of w. Newton's method cannot pass
// a root where f and f'' have the same sign, and where it meets a slope of the other sign, there is none ahead. So the
// first way into the solid is either left of -w and found from the left end, or found from w: to the left, in the middle
// piece, if f(w) < 0, and to the right if not.
#ifndef TORUS_QUARTIC_GLSL
#define TORUS_QUARTIC_GLSL

#include "line.glsl"

// A hole as small as this part of R and no tip: nearer to a horn, whose sheets meet, the exact solver does it all.
#define TORUS_RING 0.9375
// Steps of the filter. More are needed near tangents and in the thinnest tubes alone, which it leaves to others.
#define TORUS_FILTER_STEPS 24
// A crossing is near enough when a step is shorter than this part of r: Newton has squared the error by then, and the
// exact last step (torus_hit) cubes it.
#define TORUS_FILTER_STEP 0.0009765625
// Up to this, in R r (R + r)^2, rounding can have turned the sign of an extremum of f: four times what some ten
// roundings of a and of z can make of f near the surface. Clear is what is as many times further away.
#define TORUS_FILTER_DOUBT 4.0e-6
#define TORUS_FILTER_CLEAR 8.0
// The depth of a dip is that of the parabola at its edge, with at least this part of the bend of 4 dd R^2 that f has
// in the tube: where f is flat, a small slope says nothing.
#define TORUS_FILTER_FLAT 0.0625

// Whether there is a first crossing, and where, if `known`; else anything.
bool torus_filter(torus_Line line, out float crossing, out bool known) {
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE float dd = line.length2;
    TORUS_PRECISE vec3 foot = line.foot;
    TORUS_PRECISE float dz = line.direction.z;
    TORUS_PRECISE float k = foot.x * foot.x + foot.y * foot.y + foot.z * foot.z - R * R - r * r;
    TORUS_PRECISE float fourR2 = 4.0 * R * R;
    TORUS_PRECISE float twoDd = 2.0 * dd;
    TORUS_PRECISE float fourDz = fourR2 * dz;
    TORUS_PRECISE float bend = dd * k + 0.5 * fourDz * dz;
    TORUS_PRECISE float w = sqrt(max(bend * (-1.0 / 3.0), 0.0)) / dd;
    TORUS_PRECISE float enough = TORUS_FILTER_STEP * r;
    TORUS_PRECISE float size = R + r;
    TORUS_PRECISE float doubt = TORUS_FILTER_DOUBT * R * r * size * size;
    TORUS_PRECISE float clear = TORUS_FILTER_CLEAR * doubt;
    bool starts = line.lower > line.enter;
    bool second = line.lower >= -w;
    TORUS_PRECISE float u = second ? max(w, line.lower) : line.lower;
    TORUS_PRECISE float a = 0.0;
    TORUS_PRECISE float f = 0.0;
    TORUS_PRECISE float halfSlope = 0.0;
    TORUS_PRECISE float before = 0.0;
    TORUS_PRECISE float ring = TORUS_RING * R;
    bool sure = r <= ring;
    bool back = false;
    bool fresh = true;
    bool there = false;
    bool busy = sure;
    if (starts) {
        // Outside, and clearly so.
        TORUS_PRECISE float startA = dd * line.lower * line.lower + k;
        TORUS_PRECISE float startZ = foot.z + line.lower * dz;
        TORUS_PRECISE float start = startA * startA + fourR2 * ((startZ - r) * (startZ + r));
        sure = sure && start > clear;
        busy = sure;
    }
    for (int i = 0; i < TORUS_FILTER_STEPS && busy; ++i) {
        TORUS_ON_STEP
        a = dd * u * u + k;
        TORUS_PRECISE float z = foot.z + u * dz;
        f = a * a + fourR2 * ((z - r) * (z + r));
        halfSlope = twoDd * u * a + fourDz * z;
        back = second && (fresh ? f < 0.0 : back);
        TORUS_PRECISE float step = -0.5 * f / halfSlope;
        bool past = halfSlope >= 0.0 || (second ? back && u <= -w : u >= -w);
        there = !past && abs(step) <= enough;
        // The tangents before and behind a minimum meet below it. Where a search begins, nothing is below it.
        TORUS_PRECISE float met = abs(f * before);
        TORUS_PRECISE float below = clear * (abs(before) + abs(halfSlope));
        bool touches = met <= below;
        sure = !(past && touches && !fresh) && !(second && fresh && abs(f) <= clear) && !(past && back);
        bool restart = past && !second;
        busy = sure && !there && (!past || restart);
        fresh = restart;
        before = halfSlope;
        second = second || restart;
        TORUS_PRECISE float next = past ? u : u + step;
        u = restart ? max(w, line.lower) : next;
    }
    TORUS_PRECISE float halfBend = twoDd * (a + twoDd * u * u) + fourDz * dz;
    TORUS_PRECISE float depth = halfSlope * halfSlope - f * halfBend;
    TORUS_PRECISE float doubtful = clear * (abs(halfBend) + TORUS_FILTER_FLAT * dd * fourR2);
    bool deep = depth > doubtful;
    // A crossing near the ray's own end is for the exact step to compare.
    TORUS_PRECISE float left = line.upper - u;
    bool ends = line.upper < line.leave && abs(left) <= r;
    known = sure && !busy && (!there || (deep && !ends));
    crossing = u;
    return there && u <= line.upper;
}

#endif
