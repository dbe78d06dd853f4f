// SPDX-License-Identifier: MIT
// Minima first: where the reduced quartic f(u) = u^4 + p u^2 + q u + s is lowest, in closed form; whether the line hits,
// by the sign of the tube function G there; and only then roots, each from a start that the minimum gives.
//
// The extrema solve 4 u^3 + 2 p u + q = 0. With u = 2 w c, w = sqrt(-p / 6) the inflection, that is
// 4 c^3 - 3 c = x, x = -q / (8 w^3): for |x| < 1 two minima, which thirdCosine gives, and a maximum, minus their sum. Else
// there is one minimum, by Newton from above, which is monotone there. It starts at v - p / (6 v), v^3 = |q| / 4, where
// p < 0: that is Cardano's solution with the square root in it replaced by its bound, off by 3 % at most. Where p >= 0
// it starts at the lesser of v and |q| / 2 p.
// f = G (2 A - G) / dd^2, A = dd (u^2 + k), has the sign of G where it dips, and G rounds to r where f rounds to R. Near
// zero, G is taken exactly, at the bottom of its own parabola.
//
// A root lies in one piece between minimum, inflections and bounding sphere, in which f is convex or concave:
// Newton's steps, held in the piece, cannot miss it. Away from the centre, the quartic less its cubic term at the
// minimum m starts them, beyond the root: f(m) + f''(m) / 2 d^2 + d^4 = 0, near a tangent m - sqrt(-2 f / f'').
//
// What it loses: the root, not the verdict, in tubes as thin as 0.001 R, where f is rounding all through: 1 in 1000 of
// the positions is off by more than 0.01 r. And everything where R is 0 and both sheets are one.
#ifndef MINIMA_FIRST_GLSL
#define MINIMA_FIRST_GLSL

#include "cube_root.glsl"
#include "reduced_quartic.glsl"
#include "third_cosine.glsl"

#define MINIMA_CUBIC_STEPS 8
// A curvature of G below this says nothing: minimum and maximum are about to merge.
#define MINIMA_FLAT 1.0e-3

struct MinimaFirst {
    ReducedQuartic f;
    float inflection;     // 0 where there is none
    float firstMinimum;
    float secondMinimum;  // the same where there is only one
    float firstValue;     // f there
    float secondValue;
    bool first;           // the line dips into the solid at the first minimum
    bool second;
    float middle;         // the maximum between
    bool joined;          // one dip: there is one minimum, or the maximum lies inside the solid too
};

// The only real root of u^3 + p u + q. The rough cube root may be 4 % low, and has to be an upper bound.
float minimaFirstCubic(float p, float q, float enough, bool wanted) {
    TORUS_PRECISE float size = max(abs(q), 1.0e-30);
    TORUS_PRECISE float root = 1.05 * cubeRootRough(size);
    TORUS_PRECISE float u = p < 0.0 ? root - p / (3.0 * root) : min(root, size / max(p, 1.0e-15));
    bool busy = wanted;
    for (int i = 0; i < MINIMA_CUBIC_STEPS && busy; ++i) {
        TORUS_ON_STEP
        TORUS_PRECISE float step = ((u * u + p) * u - size) / (3.0 * u * u + p);
        u = u - step;
        busy = abs(step) > enough;
    }
    return q > 0.0 ? -u : u;
}

// f from G, which keeps a thin tube's digits.
float minimaFirstValue(torus_Line line, ReducedQuartic f, float u, float tube) {
    TORUS_PRECISE float scaled = tube / line.length2;
    TORUS_PRECISE float value = scaled * (2.0 * (u * u + f.k) - scaled);
    return tube <= 0.0 ? min(value, 0.0) : max(value, 1.0e-30);
}

// G at the bottom of its parabola at u: the minimum of f as rounded is not quite that of G.
float minimaFirstBottom(torus_Line line, float u) {
    torus_Point point = torus_exactPoint(line, u);
    TORUS_PRECISE float drop = point.halfSlope * point.halfSlope / max(point.halfCurvature, MINIMA_FLAT);
    TORUS_PRECISE float bottom = point.tube - drop;
    return bottom;
}

MinimaFirst minimaFirstPrepare(torus_Line line) {
    MinimaFirst state;
    ReducedQuartic f = reducedQuartic(line);
    TORUS_PRECISE float w = sqrt(max(f.p * (-1.0 / 6.0), 0.0));
    TORUS_PRECISE float cube = 8.0 * w * w * w;
    bool two = abs(f.q) < cube;
    TORUS_PRECISE float x = two ? -f.q / cube : 0.0;
    TORUS_PRECISE float right = 2.0 * w * thirdCosine(sqrt(0.5 + 0.5 * x));
    TORUS_PRECISE float left = -2.0 * w * thirdCosine(sqrt(0.5 - 0.5 * x));
    float only = minimaFirstCubic(0.5 * f.p, 0.25 * f.q, f.enough, !two);
    state.f = f;
    state.inflection = w;
    state.firstMinimum = two ? left : only;
    state.secondMinimum = two ? right : only;
    float slope;
    float firstTube = torus_tube(line, state.firstMinimum, slope);
    float secondTube = torus_tube(line, state.secondMinimum, slope);
    // Where rounding could turn a sign, the values are computed again, exactly, as in the library.
    TORUS_PRECISE float doubt = TORUS_DOUBT * line.minorRadius * (line.majorRadius + line.minorRadius);
    int afterLast = abs(secondTube) <= doubt ? 2 : 1;
    for (int i = abs(firstTube) <= doubt ? 0 : 1; i < afterLast; ++i) {
        float bottom = minimaFirstBottom(line, i == 0 ? state.firstMinimum : state.secondMinimum);
        firstTube = i == 0 ? bottom : firstTube;
        secondTube = i == 0 ? secondTube : bottom;
    }
    state.firstValue = minimaFirstValue(line, f, state.firstMinimum, firstTube);
    state.secondValue = minimaFirstValue(line, f, state.secondMinimum, secondTube);
    state.first = firstTube <= 0.0;
    state.second = secondTube <= 0.0;
    state.joined = !two;
    TORUS_PRECISE float middle = -(left + right);
    state.middle = middle;
    if (two && state.first && state.second) {
        state.joined = torus_tube(line, middle, slope) <= 0.0;
    }
    return state;
}

// Newton on a piece, from `near` where f is negative to `far` where it is positive.
float minimaFirstRun(ReducedQuartic f, float near, float far, float start, bool wanted) {
    TORUS_PRECISE float lo = min(near, far);
    TORUS_PRECISE float hi = max(near, far);
    TORUS_PRECISE float u = clamp(start, lo, hi);
    bool rising = far > near;
    bool busy = wanted;
    for (int i = 0; i < QUARTIC_ROOT_STEPS && busy; ++i) {
        TORUS_ON_STEP
        TORUS_PRECISE float slope = quarticSlope(f, u);
        TORUS_PRECISE float step = -quarticValue(f, u) / slope;
        TORUS_PRECISE float next = (rising ? slope > 0.0 : slope < 0.0) ? clamp(u + step, lo, hi) : far;
        TORUS_PRECISE float change = next - u;
        busy = abs(change) > f.enough;
        u = next;
    }
    return u;
}

// Crossing `index`: 0 into, 1 out of the first dip; 2 into, 3 out of the second. Of joined dips 0 and 3.
bool minimaFirstRoot(torus_Line line, MinimaFirst state, int index, out float u) {
    bool atFirst = index < 2;
    bool inner = index == 1 || index == 2;
    float side = index == 1 || index == 3 ? 1.0 : -1.0;
    bool exists = (atFirst ? state.first : state.second) && !(inner && state.joined);
    float minimum = atFirst ? state.firstMinimum : state.secondMinimum;
    float value = atFirst ? state.firstValue : state.secondValue;
    ReducedQuartic f = state.f;
    TORUS_PRECISE float halfBend = max(6.0 * minimum * minimum + f.p, 0.0);
    TORUS_PRECISE float depth = max(-value, 0.0);
    TORUS_PRECISE float width2 = 2.0 * depth / max(halfBend + sqrt(halfBend * halfBend + 4.0 * depth), 1.0e-30);
    TORUS_PRECISE float start = minimum + side * sqrt(width2);
    float near = minimum;
    TORUS_PRECISE float far = side * f.reach;
    // Towards the centre the root may lie before the first inflection, before the second or after it.
    TORUS_PRECISE float turn = side * state.inflection;
    if (state.inflection > 0.0 && side * minimum < 0.0) {
        if (quarticValue(f, -turn) > 0.0) {
            far = -turn;
        } else if (inner) {
            near = -turn;
            far = state.middle;
            start = near;
        } else if (quarticValue(f, turn) > 0.0) {
            near = -turn;
            far = turn;
            start = near;
        } else {
            near = turn;
        }
    }
    u = minimaFirstRun(f, near, far, start, exists);
    return exists;
}

#define QUARTIC_INTERSECT minimaFirstIntersect
#define QUARTIC_OCCLUDED minimaFirstOccluded
#define QUARTIC_INTERSECT_ALL minimaFirstIntersectAll
#define QUARTIC_STATE MinimaFirst
#define QUARTIC_PREPARE minimaFirstPrepare
#define QUARTIC_ROOT minimaFirstRoot
#define QUARTIC_DIPS
#include "quartic_hits.glsl"

#define RAY_INTERSECT minimaFirstIntersect
#define RAY_OCCLUDED minimaFirstOccluded
#define RAY_INTERSECT_ALL minimaFirstIntersectAll

#endif
