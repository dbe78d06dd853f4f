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
// Where rounding could turn the sign of the parabola's discriminant, and near a crossing, refine.glsl takes over.
#ifndef TORUS_MARCH_GLSL
#define TORUS_MARCH_GLSL

#include "ray.glsl"

// A statement for each step of each loop, for counting them: empty unless defined before.
#ifndef TORUS_ON_STEP
#define TORUS_ON_STEP
#endif

// Steps of one search. Compilers unroll a loop as short as this. A search that needs more is continued by the next.
#define TORUS_SEARCH_STEPS 6
// Searches of a query, each with a refinement. Four crossings need four; the rest is for tangents, and for the tip of a
// horn, where f is as flat as a fourth power.
#define TORUS_SEARCHES 64
// A step below this part of r is the search's last one.
#define TORUS_LAST_STEP 0.015625
// What rounding can make of 2 a, in units of R + r and twice the largest coordinate of the base, the rounding of which the
// foot inherits, over dd. On the surface a is e at most.
#define TORUS_BLUR 1.2e-6
// The next parabola holds at least this part of the last step ahead.
#define TORUS_LEAST_REACH 0.0625
// Farther than any crossing, in lengths of the direction.
#define TORUS_BEYOND 8.0

struct torus_Quartic {
    float k;
    float b0;
    float b1;
    float edge2;      // e^2
    float innerEnd;   // inside the sphere |u| < innerEnd, on which the inner sheet of a spindle ends, all is inside; else 0
    float blur;       // rounding can have made this much of f
    float lastStep;
};

torus_Quartic torus_quartic(torus_Line line) {
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
    TORUS_PRECISE float lastStep = TORUS_LAST_STEP * r;
    return torus_Quartic(k, b0, b1, edge2, innerEnd, blur, lastStep);
}

// Where the march is.
struct torus_March {
    float u;
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
float torus_firstReach(torus_Line line, float side) {
    TORUS_PRECISE float diameter = 2.0 * line.minorRadius;
    return side < 0.0 ? diameter : TORUS_BEYOND;
}

torus_March torus_startMarch(torus_Line line, torus_Quartic quartic) {
    TORUS_PRECISE float u = line.lower;
    TORUS_PRECISE float a = u * u + quartic.k;
    TORUS_PRECISE float b = quartic.b0 + u * quartic.b1;
    TORUS_PRECISE float f = a * a + (b * b - quartic.edge2);
    // Of a start on the surface, the refinement decides.
    bool within = u >= -quartic.innerEnd && u < quartic.innerEnd;
    bool inside = line.fromStart && (f < 0.0 || within);
    bool doubtful = line.fromStart && abs(f) <= quartic.blur && !within;
    float side = inside ? -1.0 : 1.0;
    return torus_March(u, doubtful ? 0.0 : side, torus_firstReach(line, side), true, doubtful, false, false, 0.0, 0.0);
}

// One step towards the next crossing, or a decision that it is time for a refinement.
void torus_step(torus_Quartic quartic, float limit, inout torus_March march) {
    float u = march.u;
    float reach = march.reach;
    bool known = march.known;
    TORUS_PRECISE float twoU = 2.0 * u;
    TORUS_PRECISE float a = u * u + quartic.k;
    TORUS_PRECISE float b = quartic.b0 + u * quartic.b1;
    TORUS_PRECISE float f = a * a + (b * b - quartic.edge2);
    TORUS_PRECISE float h = twoU * a + quartic.b1 * b;
    TORUS_PRECISE float c = 2.0 * a + quartic.b1 * quartic.b1;
    f = known ? march.f : f;
    h = known ? march.h : h;
    // (2 u + x)^2 within reach: at least `bound`^2 outside, at most inside.
    TORUS_PRECISE float ahead = twoU + reach;
    TORUS_PRECISE float least = twoU > 0.0 ? twoU : min(ahead, 0.0);
    TORUS_PRECISE float bound = march.side < 0.0 ? max(abs(twoU), abs(ahead)) : least;
    // The parabola g + 2 s x + C x^2, which is positive here, and whether rounding can have turned its discriminant.
    TORUS_PRECISE float g = march.side * f;
    TORUS_PRECISE float s = march.side * h;
    TORUS_PRECISE float C = march.side * (c + bound * bound);
    TORUS_PRECISE float ss = s * s;
    TORUS_PRECISE float discriminant = ss - C * g;
    TORUS_PRECISE float blur = (known ? 0.5 * abs(s) : abs(C) + abs(s)) * quartic.blur;
    TORUS_PRECISE float fourBlurs = 4.0 * blur;
    bool doubtful = abs(discriminant) < blur;
    // Its first root, in the form that does not cancel.
    TORUS_PRECISE float root = sqrt(max(discriminant, 0.0));
    bool nears = s < 0.0;
    TORUS_PRECISE float x = (nears ? g : root + s) / (nears ? root - s : -C);
    // A refinement that found nothing is not repeated at the same place. From past a shallow dip's extremum it leads back.
    TORUS_PRECISE float reached = u + x;
    TORUS_PRECISE float twiceSs = 2.0 * ss;
    bool stuck = known && reached == u;
    bool behind = known && discriminant > twiceSs;
    bool rises = C >= 0.0 && !behind;
    bool none = (nears ? discriminant <= -blur : rises) || !(x <= reach) || stuck;
    bool close = nears && x <= quartic.lastStep;
    // The slope of f itself may change by a quarter on the way: then f follows the parabola to below zero.
    TORUS_PRECISE float slopeChange = (abs(c) + twoU * twoU) * x;
    TORUS_PRECISE float quarterSlope = -0.25 * s;
    bool crosses = close && !none && !doubtful && slopeChange <= quarterSlope;
    bool holds = doubtful && !known && (close || ss <= fourBlurs);
    // Of a parabola that has no root but for its rounding not beyond its extremum.
    x = discriminant < 0.0 ? 0.75 * x : x;
    x = none ? reach : (known ? x : max(x, 0.0));
    TORUS_PRECISE float next = u + x;
    TORUS_PRECISE float further = none ? 4.0 * reach : max(2.0 * x, TORUS_LEAST_REACH * quartic.lastStep);
    TORUS_PRECISE float past = next + quartic.lastStep;
    march.certain = crosses && past <= limit;
    march.refines = holds || (crosses && next <= limit);
    march.u = holds ? u : next;
    march.reach = march.refines ? reach : further;
    march.known = false;
}

// Marches until a refinement is due, or to the end of the interval.
void torus_search(torus_Quartic quartic, float upper, inout torus_March march) {
    // Nothing is to be found where the inner sheet is. Who comes there from outside is past a crossing, at a dimple's tip.
    float innerEnd = quartic.innerEnd;
    bool within = !march.refines && march.u >= -innerEnd && march.u < innerEnd;
    bool late = within && march.side > 0.0;
    march.u = within && !late ? innerEnd : march.u;
    march.refines = march.refines || late;
    bool before = march.u < -innerEnd && innerEnd > 0.0;
    float limit = before ? min(-innerEnd, upper) : upper;
    TORUS_PRECISE float left = limit - march.u;
    march.reach = min(march.reach, left);
    march.certain = false;
    for (int i = 0; i < TORUS_SEARCH_STEPS && !march.refines && march.u < limit; ++i) {
        TORUS_ON_STEP
        torus_step(quartic, limit, march);
    }
    // From outside the inner sheet's end is reached but through a crossing.
    bool atInnerEnd = !(march.u < limit) && limit < upper;
    march.refines = march.refines || (atInnerEnd && march.side > 0.0);
    march.searching = march.refines || march.u < upper;
    march.known = late;
}

#endif
