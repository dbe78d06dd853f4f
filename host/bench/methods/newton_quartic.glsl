// SPDX-License-Identifier: MIT
// Monotone Newton by convexity on the reduced quartic f(u) = u^4 + p u^2 + q u + s.
//
// f'' = 12 u^2 + 2 p, so the inflections are -w and w, w = sqrt(-p / 6), inside the bounding sphere, and f is convex left
// of -w, concave between, convex right of w. From a point where f and f'' have the same sign Newton's steps run
// towards the next root of the piece without ever passing it (Fourier; Householder, The Numerical Treatment of a
// Single Nonlinear Equation, 1970, section 4.2). They find it, or the slope turns, or they leave the piece: then it has
// no root there. So the four crossings of the line, into the solid and out and in and out again, are each reached
// from one of four starts, without brackets:
//
//     0  into     from -reach rightwards, in the left piece
//     1  out of   from -w: leftwards if f(-w) > 0, in the left piece; else rightwards, in the middle
//     2  into     from w: rightwards if f(w) > 0, in the right piece; else leftwards, in the middle
//     3  out of   from reach leftwards, in the right piece
//
// Where p >= 0, f is convex as a whole, and only 0 and 3 are left.
// What it loses: a dip or a gap shallower than the rounding of the quartic, some 1e-7 R^4. From r/R = 0.1 on that is less
// than 1e-4 r; in a tube of 0.001 R it is more than 1e-3 r, and 0.6 % of the clear rays go wrong.
#ifndef NEWTON_QUARTIC_GLSL
#define NEWTON_QUARTIC_GLSL

#include "reduced_quartic.glsl"

struct NewtonQuartic {
    ReducedQuartic f;
    float inflection;   // w; negative where there is none
    float leftValue;    // f(-w)
    float rightValue;   // f(w)
};

NewtonQuartic newtonQuarticPrepare(torus_Line line) {
    NewtonQuartic state;
    state.f = reducedQuartic(line);
    TORUS_PRECISE float w = sqrt(max(state.f.p * (-1.0 / 6.0), 0.0));
    state.inflection = state.f.p < 0.0 ? w : -1.0;
    state.leftValue = quarticValue(state.f, -w);
    state.rightValue = quarticValue(state.f, w);
    return state;
}

// Newton from `start` towards `limit` as long as sign * f is positive and falls; false if it does not reach zero.
bool newtonQuarticRun(ReducedQuartic f, float sign, float start, float limit, bool wanted, out float u) {
    TORUS_PRECISE float at = start;
    bool rightwards = limit > start;
    bool found = false;
    bool busy = wanted;
    for (int i = 0; i < QUARTIC_ROOT_STEPS && busy; ++i) {
        TORUS_ON_STEP
        TORUS_PRECISE float value = sign * quarticValue(f, at);
        TORUS_PRECISE float slope = sign * quarticSlope(f, at);
        bool falls = rightwards ? slope < 0.0 : slope > 0.0;
        TORUS_PRECISE float step = falls ? -value / slope : 0.0;
        TORUS_PRECISE float next = at + step;
        // Not positive: rounding has taken the last step past the root.
        bool passed = value <= 0.0;
        bool inPiece = rightwards ? next <= limit : next >= limit;
        found = passed || (falls && inPiece && abs(step) <= f.enough);
        busy = !found && falls && inPiece;
        at = passed ? at : next;
    }
    u = at;
    // Steps used up: as near to a tangent as float32 can tell. The run has not met a rising f, so call it a root.
    return wanted && (found || busy);
}

// Root `index`, 0 to 3, of the quartic, if it exists.
bool newtonQuarticRoot(torus_Line line, NewtonQuartic state, int index, out float u) {
    bool left = index < 2;
    bool fromSphere = index == 0 || index == 3;
    float w = state.inflection;
    float value = left ? state.leftValue : state.rightValue;
    float mirror = left ? 1.0 : -1.0;
    bool convex = fromSphere || value > 0.0;
    float start = mirror * (fromSphere ? -state.f.reach : -w);
    float limit = mirror * (fromSphere ? (w >= 0.0 ? -w : state.f.reach) : (value > 0.0 ? -state.f.reach : w));
    bool found = newtonQuarticRun(state.f, convex ? 1.0 : -1.0, start, limit, fromSphere || w >= 0.0, u);
    // The inner sheet of a spindle has roots too.
    TORUS_PRECISE float sheet = u * u + state.f.k;
    return found && sheet >= 0.0;
}

#define QUARTIC_INTERSECT newtonQuarticIntersect
#define QUARTIC_OCCLUDED newtonQuarticOccluded
#define QUARTIC_INTERSECT_ALL newtonQuarticIntersectAll
#define QUARTIC_STATE NewtonQuartic
#define QUARTIC_PREPARE newtonQuarticPrepare
#define QUARTIC_ROOT newtonQuarticRoot
#include "quartic_hits.glsl"

#define RAY_INTERSECT newtonQuarticIntersect
#define RAY_OCCLUDED newtonQuarticOccluded
#define RAY_INTERSECT_ALL newtonQuarticIntersectAll

#endif
