// SPDX-License-Identifier: MIT
// Private: the march, which finds the crossings of a line with the torus in ascending order, by steps that pass none.
//
// A point p of the torus has |p|^2 - R^2 - r^2 = +-2 R sqrt(r^2 - z^2). Along the line, where |p|^2 = dd u^2 + |foot|^2,
// that is a root of
//
//     f(u) = a^2 + b^2 - e^2,    a = u^2 + k,    k = (|foot|^2 - R^2 - r^2) / dd,    b = 2 R z / dd = b0 + b1 u,
//     e = 2 R r / dd                                                                        (math.md, eq. 28)
//
// f is positive outside a ring and negative inside. From any u, exactly (math.md, eq. 29),
//
//     f(u + x) = f + 2 h x + c x^2 + (2 u x + x^2)^2,    h = f'(u) / 2 = 2 u a + b1 b,    c = 2 a + b1^2
//
// and for 0 <= x <= reach the last term is between m x^2 and M x^2, with m and M the least and the largest of
// (2 u + x)^2 there. So the parabola f + 2 h x + (c + m) x^2 is nowhere above f: outside, its first root is not beyond the
// first crossing, and where it has none, there is no crossing within reach. Inside, the same holds for -f with -(c + M)
// (math.md, eq. 30).
// With a reach of twice the last step the parabola is nearly f, and the steps converge faster than Newton's.
//
// Near a crossing, refine.glsl takes over, and where rounding could turn the sign of the parabola's discriminant. The fast
// tier takes that sign as it is, and refine_fast.glsl takes over near a crossing.
#ifndef TORUS_MARCH_GLSL
#define TORUS_MARCH_GLSL

#include "ray.glsl"

// Statements for each pass, each step and each refinement, for counting them: empty unless defined before.
#ifndef TORUS_ON_PASS
#define TORUS_ON_PASS
#endif
#ifndef TORUS_ON_STEP
#define TORUS_ON_STEP
#endif
#ifndef TORUS_ON_REFINEMENT
#define TORUS_ON_REFINEMENT
#endif

// A pass is some steps and the refinement after them. A crossing that needs more steps is found by the next pass; loops as
// short as this are unrolled by compilers.
#define TORUS_PASS_STEPS 4
// Passes of a query. Four crossings need four to eight; the rest is for tangents, and for the tip of a horn, where f is as
// flat as a fourth power.
#define TORUS_PASSES 64
// A step below this part of r may lead to a crossing.
#define TORUS_LAST_STEP 0.015625
// ... or a step of this length, in units: u itself is rounded by as much.
#define TORUS_STEP_ROUNDING 1.1920929e-7
// The error of 2 a by rounding: this much of (R + r + 2 farthest) / dd. The foot inherits the rounding of the base, whose
// largest coordinate is `farthest`. A step whose sign of the discriminant this can turn is doubtful (accuracy.md, verdicts).
#define TORUS_BLUR 1.2e-6
// The next parabola holds at least this part of such a step ahead. No step of the fast tier but to a crossing is shorter.
#define TORUS_LEAST_REACH 0.0625
// Farther than any crossing, in lengths of the direction.
#define TORUS_BEYOND 8.0

struct torus_Quartic {
    float k;
    float b0;
    float b1;
    float edge2;      // e^2
    float innerEnd;   // inside the sphere |u| < innerEnd, on which the inner sheet of a spindle ends, all is inside; else 0
    float blurOfA;    // rounding can have made this much of 2 a ...
    float blur;       // ... and this much of f
    float minorRadius;
};

torus_Quartic torus_quartic(const torus_Line line) {
    TORUS_PRECISE float R = line.majorRadius;
    TORUS_PRECISE float r = line.minorRadius;
    TORUS_PRECISE float invDd = line.invLength2;
    TORUS_PRECISE float k = (line.foot2 - R * R - r * r) * invDd;
    TORUS_PRECISE float twoR = 2.0 * R * invDd;
    TORUS_PRECISE float b0 = twoR * line.foot.z;
    TORUS_PRECISE float b1 = twoR * line.direction.z;
    TORUS_PRECISE float edge = twoR * r;
    TORUS_PRECISE float edge2 = edge * edge;
    TORUS_PRECISE float innerEnd = sqrt(max(-(k + twoR * R), 0.0));
    TORUS_PRECISE float blurOfA = TORUS_BLUR * (R + r + 2.0 * line.farthest) * invDd;
    TORUS_PRECISE float blur = blurOfA * (edge + blurOfA);
    return torus_Quartic(k, b0, b1, edge2, innerEnd, blurOfA, blur, r);
}

// Where the march is.
struct torus_March {
    float u;
    float from;       // no crossing before is still to be found
    float side;       // 1: outside, -1: inside, 0: to be decided by the refinement that is due
    float reach;      // the next step's parabola has to hold as far ahead
    bool searching;   // false: no further crossing
    bool refines;     // the refinement is due: near a crossing, or where rounding leaves in doubt whether there is one
    bool certain;     // ... near a crossing that there is
    bool known;       // f and h are those of u, from a refinement; or, if one is due, it must find the crossing
    float f;
    float h;
};

// How far ahead the first parabola has to hold: from outside to the end, and inside twice the tube's radius, for the
// farther it holds, the less it bends.
float torus_firstReach(const torus_Line line, float side) {
    TORUS_PRECISE float diameter = 2.0 * line.minorRadius;
    return side < 0.0 ? diameter : TORUS_BEYOND;
}

torus_March torus_startMarch(const torus_Line line, const torus_Quartic quartic) {
    TORUS_PRECISE float u = line.lower;
    TORUS_PRECISE float a = u * u + quartic.k;
    TORUS_PRECISE float b = quartic.b0 + u * quartic.b1;
    TORUS_PRECISE float f = a * a + (b * b - quartic.edge2);
    // Of a start on the surface, the refinement decides; the fast tier takes the side to which the ray goes.
    bool within = u >= -quartic.innerEnd && u < quartic.innerEnd;
    bool onSurface = abs(f) <= quartic.blur;
    TORUS_PRECISE float h = 2.0 * u * a + quartic.b1 * b;
    bool below = (!TORUS_EXACT && onSurface ? h : f) < 0.0;
    bool inside = line.fromStart && (below || within);
    bool doubtful = TORUS_EXACT && line.fromStart && onSurface && !within;
    float side = inside ? -1.0 : 1.0;
    return torus_March(u, u, doubtful ? 0.0 : side, torus_firstReach(line, side), true, doubtful, false, false, 0.0, 0.0);
}

// A parabola g + 2 s x + C x^2 that is positive at x = 0 and, up to the march's reach, not above f outside, or -f inside.
struct torus_Parabola {
    float g;
    float s;
    float C;
    float bend;  // how fast the slope of f can change, with room for what a far reach makes of C
};

torus_Parabola torus_parabola(const torus_Quartic quartic, torus_March march) {
    float u = march.u;
    TORUS_PRECISE float twoU = 2.0 * u;
    TORUS_PRECISE float a = u * u + quartic.k;
    TORUS_PRECISE float b = quartic.b0 + u * quartic.b1;
    TORUS_PRECISE float f = a * a + (b * b - quartic.edge2);
    TORUS_PRECISE float h = twoU * a + quartic.b1 * b;
    TORUS_PRECISE float c = 2.0 * a + quartic.b1 * quartic.b1;
    if (TORUS_EXACT) {
        f = march.known ? march.f : f;
        h = march.known ? march.h : h;
    }
    // (2 u + x)^2 within reach: at least `bound`^2 outside, at most inside.
    TORUS_PRECISE float ahead = twoU + march.reach;
    TORUS_PRECISE float least = max(max(twoU, -ahead), 0.0);
    TORUS_PRECISE float bound = march.side < 0.0 ? max(abs(twoU), abs(ahead)) : least;
    TORUS_PRECISE float g = march.side * f;
    TORUS_PRECISE float s = march.side * h;
    // The smaller C is, the farther is a far root. Rounding must not bring it nearer, so take the least C that it allows.
    TORUS_PRECISE float rounding = TORUS_EXACT && s >= 0.0 ? quartic.blurOfA : 0.0;
    TORUS_PRECISE float C = march.side * (c + bound * bound) - rounding;
    TORUS_PRECISE float twoReach = 2.0 * march.reach;
    TORUS_PRECISE float bend = abs(c) + (twoU * twoU + twoReach * twoReach);
    return torus_Parabola(g, s, C, bend);
}

// One step towards the next crossing, or a decision that it is time for a refinement. `left` is what is left of the
// interval.
void torus_step(const torus_Quartic quartic, float left, inout torus_March march) {
    float u = march.u;
    float reach = march.reach;
    TORUS_PRECISE float lastStep = TORUS_LAST_STEP * quartic.minorRadius + TORUS_STEP_ROUNDING;
    bool known = TORUS_EXACT && march.known;
    torus_Parabola p = torus_parabola(quartic, march);
    TORUS_PRECISE float ss = p.s * p.s;
    TORUS_PRECISE float discriminant = ss - p.C * p.g;
    // Whether rounding can have turned its sign.
    TORUS_PRECISE float blur = TORUS_EXACT ? (known ? 0.5 * abs(p.s) : abs(p.C) + abs(p.s)) * quartic.blur : 0.0;
    bool doubtful = abs(discriminant) < blur;
    // The first root, in the form that does not cancel.
    TORUS_PRECISE float root = sqrt(max(discriminant, 0.0));
    bool nears = p.s < 0.0;
    TORUS_PRECISE float x = (nears ? p.g : root + p.s) / (nears ? root - p.s : -p.C);
    bool rises = p.C >= 0.0;
    // Who is on the other side already, by rounding, is past a crossing.
    bool past = !TORUS_EXACT && p.g <= 0.0;
    if (TORUS_EXACT) {
        // A parabola without a root, which may have one but for rounding, is followed to three quarters of its extremum.
        x = discriminant < 0.0 ? 0.75 * x : x;
        // A refinement that found nothing is not repeated at the same place. From past a shallow dip's extremum it leads
        // back.
        TORUS_PRECISE float reached = u + x;
        TORUS_PRECISE float twiceSs = 2.0 * ss;
        rises = rises && !(known && discriminant > twiceSs);
        x = known && reached == u ? TORUS_BEYOND : x;
    }
    bool none = nears ? discriminant <= -blur && !past : rises;
    x = none ? TORUS_BEYOND : x;
    // The slope of f itself may change by a quarter on the way: then f follows the parabola to below zero.
    TORUS_PRECISE float slopeChange = p.bend * x;
    TORUS_PRECISE float quarterSlope = -0.25 * p.s;
    bool close = x <= min(lastStep, reach);
    bool crosses = close && slopeChange < quarterSlope;
    TORUS_PRECISE float leastStep = TORUS_LEAST_REACH * lastStep;
    bool holds = false;
    if (TORUS_EXACT) {
        TORUS_PRECISE float fourBlurs = 4.0 * blur;
        bool tangent = doubtful && ((close && nears) || ss <= fourBlurs);
        bool noise = nears && p.g < quartic.blur && !crosses;
        holds = !known && (tangent || noise);
        x = known ? x : max(x, 0.0);
    } else {
        x = crosses ? max(x, -lastStep) : max(x, leastStep);
    }
    x = min(x, reach);
    TORUS_PRECISE float next = u + x;
    TORUS_PRECISE float further = max(2.0 * x, leastStep);
    TORUS_PRECISE float after = x + (lastStep + TORUS_END_PADDING);
    march.certain = crosses && p.g > quartic.blur && after <= left;
    march.refines = holds || crosses;
    march.u = holds ? u : next;
    march.reach = march.refines ? reach : further;
}

// Marches on until a refinement is due, by at most so many steps.
void torus_search(const torus_Quartic quartic, float upper, int steps, inout torus_March march) {
    TORUS_ON_PASS
    bool busy = !march.refines && march.u < upper;
    for (int i = 0; i < steps && busy; ++i) {
        TORUS_ON_STEP
        // Nothing is to be found where the inner sheet of a spindle is. Who comes there from outside is past a crossing,
        // at a dimple's tip.
        bool late = false;
        if (quartic.innerEnd > 0.0) {
            bool within = march.u >= -quartic.innerEnd && march.u < quartic.innerEnd;
            late = within && march.side > 0.0;
            march.u = within && !late ? quartic.innerEnd : march.u;
        }
        TORUS_PRECISE float left = late ? 0.0 : upper - march.u;
        march.reach = min(march.reach, left);
        torus_step(quartic, left, march);
        march.refines = march.refines || late;
        march.known = late;
        busy = !march.refines && march.u < upper;
    }
    march.searching = march.refines || march.u < upper;
}

#endif
