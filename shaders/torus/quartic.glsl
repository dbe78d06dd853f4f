// SPDX-License-Identifier: MIT
// Private: a filter before the exact solver. It finds the crossings of nearly every ray that starts outside a ring, or
// proves that there are none, with a tenth of the work, and says of every other ray that it does not know.
//
// A point p of the torus has |p|^2 - R^2 - r^2 = +-2 R sqrt(r^2 - z^2). Along the line, where |p|^2 = dd u^2 + |foot|^2,
// that is a zero of
//
//     f(u) = a^2 + (b - b_r)(b + b_r),    a = u^2 + k,    k = (|foot|^2 - R^2 - r^2) / dd,
//     b = 2 R z / dd,    b_r = 2 R r / dd                                              (math.md, eq. 28)
//
// which is negative inside a ring, has no root in it, and loses no thin tube to its coefficients: near the surface both
// terms are of the size of R^2 r^2.
//
// f'' is zero at -w and w: f is convex left of -w, concave between them, convex right of w. Newton's method cannot pass
// a root where f and f'' have the same sign, and where it meets a slope of the other sign, there is none ahead. So the
// first way into the solid is either left of -w and found from the left end, or found from w: to the left, in the middle
// piece, if f(w) < 0, and to the right if not. The last ways out of it are the same on the mirrored line.
#ifndef TORUS_QUARTIC_GLSL
#define TORUS_QUARTIC_GLSL

#include "line.glsl"

// Steps of a search. More are needed near tangents and in the thinnest tubes alone, which it leaves to others; of a loop
// as short as this, compilers make no loop.
#define TORUS_SEARCH_STEPS 8
// A crossing is near enough when Newton's next error is less than this part of r: the last step (last_step.glsl) cubes
// it.
#define TORUS_SEARCH_ERROR 0.0009765625
// Up to this, in R r (R + r)^2, rounding can have turned the sign of an extremum of f: four times what some ten
// roundings of a and of z usually make of f near the surface. Clear is what is as many times further away: that is four
// times what the rounding of a foot can make of f that an origin 8 units away leads to.
#define TORUS_FILTER_DOUBT 4.0e-6
#define TORUS_FILTER_CLEAR 8.0
// f bends by at least this part of the 4 R^2 / dd that it bends by in the tube: where it is flat, a small slope says
// nothing of a dip's depth, and a small bend nothing of the next error.
#define TORUS_FILTER_FLAT 0.0625
// The steepness where nothing has been seen of f yet.
#define TORUS_UNSEEN 1.0e30

struct torus_Quartic {
    float k;
    float b0;          // b = b0 + u b1
    float b1;
    float edge;
    float inflection;  // w; 0 where f is convex everywhere
    float bend;        // f'' = 12 (u^2 + bend)
    float leastBend;   // of the same unit: f'' / 12
    float clear;       // an extremum of f further from 0 than this has its sign
    float enough;      // a sixth of the error of a crossing that is near enough
};

// f and its slope at a place, and a there.
struct torus_Value {
    float a;
    float f;
    float slope;
};

torus_Quartic torus_quartic(torus_Line line) {
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE float perDd = line.perLength2;
    TORUS_PRECISE float k = (line.foot2 - R * R - r * r) * perDd;
    TORUS_PRECISE float twoR = 2.0 * R * perDd;
    TORUS_PRECISE float b0 = twoR * line.foot.z;
    TORUS_PRECISE float b1 = twoR * line.direction.z;
    TORUS_PRECISE float edge = twoR * r;
    TORUS_PRECISE float bend = (k + 0.5 * b1 * b1) * (1.0 / 3.0);
    TORUS_PRECISE float inflection = sqrt(max(-bend, 0.0));
    TORUS_PRECISE float leastBend = TORUS_FILTER_FLAT / 3.0 * R * twoR;
    TORUS_PRECISE float clear = 0.5 * TORUS_FILTER_CLEAR * TORUS_FILTER_DOUBT * line.outer2 * (edge * perDd);
    TORUS_PRECISE float enough = TORUS_SEARCH_ERROR / 6.0 * r;
    return torus_Quartic(k, b0, b1, edge, inflection, bend, leastBend, clear, enough);
}

// On the line (b1 as it is) or on the mirrored one (-b1).
torus_Value torus_quarticAt(torus_Quartic quartic, float b1, float u) {
    TORUS_PRECISE float a = u * u + quartic.k;
    TORUS_PRECISE float b = quartic.b0 + u * b1;
    TORUS_PRECISE float f = a * a + (b - quartic.edge) * (b + quartic.edge);
    TORUS_PRECISE float slope = 4.0 * u * a + 2.0 * b1 * b;
    return torus_Value(a, f, slope);
}

// Whether the line starts in what the filter knows: clearly outside a ring. The radii alone decide no branch: there are
// drivers that compile a shader anew for each submission, if a uniform decides one.
bool torus_startsClear(torus_Line line, torus_Quartic quartic) {
    TORUS_PRECISE float ring = TORUS_RING * line.majorRadius;
    bool outside = line.lower <= line.enter || torus_quarticAt(quartic, quartic.b1, line.lower).f > quartic.clear;
    return outside && line.minorRadius <= ring;
}

// A way into the solid, if it is `known` whether there is one.
struct torus_Way {
    bool known;
    bool found;
    float u;
    bool early;  // not from w
};

// The first way in from `from` on, where the line is outside. `later`: only of those found from w. If not `both`, either
// of those or of the others, but not of both. Costs nothing unless `wanted`.
torus_Way torus_search(torus_Quartic quartic, bool mirrored, float from, bool later, bool both, bool wanted) {
    TORUS_PRECISE float w = quartic.inflection;
    TORUS_PRECISE float b1 = mirrored ? -quartic.b1 : quartic.b1;
    TORUS_PRECISE float twoB1 = 2.0 * b1;
    TORUS_PRECISE float middle = max(w, from);
    TORUS_PRECISE float atMiddle = torus_quarticAt(quartic, b1, middle).f;
    // From w to the left, or to the right, or unclear. Beyond w there is but one side.
    bool beyondW = from >= w;
    bool toTheLeft = atMiddle < 0.0 && !beyondW;
    bool laterKnown = beyondW || abs(atMiddle) > quartic.clear;
    // A start outside and f(w) < 0 have a way in between.
    bool laterMayMiss = !(both && toTheLeft);
    TORUS_PRECISE float u = later ? middle : from;
    bool early = !later;
    // How steep the last tangent was, of a piece of which one has been seen.
    TORUS_PRECISE float before = TORUS_UNSEEN;
    bool found = false;
    bool known = false;
    bool busy = wanted && (early || laterKnown);
    for (int i = 0; i < TORUS_SEARCH_STEPS && busy; ++i) {
        TORUS_ON_STEP
        TORUS_PRECISE float uu = u * u;
        TORUS_PRECISE float a = uu + quartic.k;
        TORUS_PRECISE float b = quartic.b0 + u * b1;
        TORUS_PRECISE float f = a * a + (b - quartic.edge) * (b + quartic.edge);
        TORUS_PRECISE float slope = 4.0 * u * a + twoB1 * b;
        TORUS_PRECISE float step = f / slope;
        // Behind a minimum, or out of its piece: of those found from w only a gap's search, which need not end before it.
        bool leaves = early ? u > -w : !both && toTheLeft && u < -w;
        bool past = slope >= 0.0 || leaves;
        TORUS_PRECISE float steep = abs(slope);
        TORUS_PRECISE float error = step * step * (abs(uu + quartic.bend) + quartic.leastBend);
        TORUS_PRECISE float enough = quartic.enough * steep;
        found = !past && error <= enough;
        // The tangents before and behind an extremum meet beyond it.
        TORUS_PRECISE float met = abs(f * before);
        TORUS_PRECISE float least = quartic.clear * (before + steep);
        bool mayMiss = early ? laterKnown : laterMayMiss;
        bool sure = !past || (met > least && mayMiss);
        // Past the early piece it begins again from w.
        bool goesOn = past ? early : !found;
        known = sure && !goesOn;
        busy = sure && goesOn;
        TORUS_PRECISE float next = u - step;
        u = past ? middle : next;
        before = past ? TORUS_UNSEEN : steep;
        early = early && !past;
    }
    // The depth of a dip is that of the parabola at its edge. What the loop does not have to keep costs less to be found
    // once more: CPU drivers mask each value that leaves a branch, in each step.
    torus_Value at = torus_quarticAt(quartic, b1, u);
    TORUS_PRECISE float bend = u * u + quartic.bend;
    TORUS_PRECISE float depth = (1.0 / 24.0) * at.slope * at.slope - at.f * bend;
    TORUS_PRECISE float shallow = quartic.clear * (abs(bend) + quartic.leastBend);
    known = known && (!found || depth > shallow);
    return torus_Way(known, found, u, early);
}

// The first way in of an interval that starts outside.
torus_Way torus_firstWay(torus_Line line, torus_Quartic quartic) {
    bool later = line.lower >= -quartic.inflection;
    return torus_search(quartic, false, line.lower, later, true, torus_startsClear(line, quartic));
}

// All crossings from line.lower to the line's end, in ascending order in, out, in, out. Flat, because glslang hands
// `precise` on through structures in structures by way of each path through them, until memory ends.
struct torus_Ways {
    bool known;
    int count;     // 0, 2 or 4
    float first;
    float second;  // ... and so on, as far as they count
    float third;
    float fourth;
    bool enters;   // whether there is a `first`, as torus_firstWay finds it, even if not all are known
};

torus_Ways torus_allWays(torus_Line line, torus_Quartic quartic) {
    TORUS_PRECISE float w = quartic.inflection;
    TORUS_PRECISE float end = -line.leave;
    bool known = torus_startsClear(line, quartic);
    torus_Way none = torus_Way(true, false, 0.0, false);
    torus_Way wayIn = none;
    torus_Way wayOut = none;
    torus_Way gapIn = none;
    torus_Way gapOut = none;
    // The first way in and the last way out. If neither is found from w, there may be a gap between them, which ends
    // with a way in and begins with a way out that are.
    for (int i = 0; i < 4; ++i) {
        bool back = i == 1 || i == 3;
        bool both = i < 2;
        float from = back ? end : line.lower;
        bool later = !both || from >= -w;
        bool outer = wayIn.early && wayOut.early;
        bool needed = i == 0 || (i == 1 && wayIn.found) || (i == 2 && outer) || gapIn.found;
        torus_Way way = torus_search(quartic, back, from, later, both, known && needed);
        bool finds = way.known && way.found;
        known = known && (way.known || !needed);
        if (i == 0) {
            wayIn = torus_Way(way.known, finds, way.u, finds && way.early);
        } else if (i == 1) {
            wayOut = torus_Way(way.known, finds, -way.u, finds && way.early);
        } else if (i == 2) {
            gapIn = torus_Way(way.known, finds, way.u, false);
        } else {
            gapOut = torus_Way(way.known, finds, -way.u, false);
        }
    }
    bool four = gapIn.found && gapOut.found;
    float second = four ? gapOut.u : wayOut.u;
    float third = four ? gapIn.u : wayOut.u;
    bool ordered = wayIn.u <= second && second <= third && third <= wayOut.u;
    bool paired = wayOut.found && gapIn.found == gapOut.found;
    known = known && (!wayIn.found || (paired && ordered));
    int count = wayIn.found ? (four ? 4 : 2) : 0;
    return torus_Ways(known, count, wayIn.u, second, third, wayOut.u, wayIn.found);
}

#endif
