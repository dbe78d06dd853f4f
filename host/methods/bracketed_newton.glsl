// SPDX-License-Identifier: MIT
// Method: bracketed Newton between the critical points of the reduced quartic, exact last step.
// Tolerance: 4e-7 (R + r).
//
// Bracketed Newton between critical points (Yuksel, High-Performance Polynomial Root Finding for Graphics, Proceedings
// of the ACM on Computer Graphics 5, 2022), on the reduced quartic f(u) = u^4 + p u^2 + q u + s:
//
//   - f'' = 12 u^2 + 2 p has its roots in closed form, the inflections -w and w;
//   - between them f' is monotone, and where it changes sign over a piece, Newton from the middle of the piece, with the
//     bracket narrowed at each step and halved where a step leaves it, finds the critical point;
//   - between the critical points f is monotone, and the same iteration finds its root where the signs differ.
//
// Only what the query needs: the maximum is minus the sum of the minima (f' has no quadratic term), the first
// crossing needs one root, and any-hit none: the signs at the critical points tell.
// What it loses: verdicts within the rounding of f, which is that of (R + r)^4, not of r: nearly all near tangents, and in
// the thinnest tubes some on clear rays.
#ifndef BRACKETED_NEWTON_GLSL
#define BRACKETED_NEWTON_GLSL

#include "parts/reduced_quartic.glsl"

struct BracketedNewton {
    ReducedQuartic f;
    float firstMinimum;
    float middle;         // the maximum between
    float secondMinimum;  // the first where there is only one, as is the middle
    bool two;
    bool first;           // f is negative at the first minimum
    bool second;
    bool joined;          // one dip: there is one minimum, or f is negative at the maximum too
};

// The root of f, or of f' / 4, between lo and hi, where it rises if `rising`, else falls.
float bracketedNewtonRun(ReducedQuartic f, bool derivative, float lo, float hi, bool rising, bool wanted) {
    TORUS_PRECISE float u = 0.5 * (lo + hi);
    bool busy = wanted;
    for (int i = 0; i < QUARTIC_ROOT_STEPS && busy; ++i) {
        TORUS_ON_STEP
        TORUS_PRECISE float cubic = (u * u + 0.5 * f.p) * u + 0.25 * f.q;
        TORUS_PRECISE float value = derivative ? cubic : quarticValue(f, u);
        TORUS_PRECISE float slope = derivative ? 3.0 * u * u + 0.5 * f.p : 4.0 * cubic;
        bool beyond = (value > 0.0) == rising;
        lo = beyond ? lo : u;
        hi = beyond ? u : hi;
        TORUS_PRECISE float newton = u - value / slope;
        TORUS_PRECISE float halved = 0.5 * (lo + hi);
        TORUS_PRECISE float next = newton >= lo && newton <= hi ? newton : halved;
        TORUS_PRECISE float change = next - u;
        busy = abs(change) > f.enough;
        u = next;
    }
    return u;
}

BracketedNewton bracketedNewtonPrepare(torus_Line line) {
    BracketedNewton state;
    ReducedQuartic f = reducedQuartic(line);
    TORUS_PRECISE float w = sqrt(max(f.p * (-1.0 / 6.0), 0.0));
    // A quarter of f' at -w and at w, its maximum and its minimum there.
    TORUS_PRECISE float edge = 2.0 * w * w * w;
    TORUS_PRECISE float left = 0.25 * f.q + edge;
    TORUS_PRECISE float right = 0.25 * f.q - edge;
    bool hasLeft = left > 0.0;
    bool hasRight = right < 0.0 || !hasLeft;
    state.f = f;
    state.two = hasLeft && hasRight;
    float minima[2] = float[2](0.0, 0.0);
    for (int i = 0; i < 2; ++i) {
        bool wanted = i == 0 ? hasLeft : hasRight;
        // Where f is convex as a whole, w = 0 and the sign of q tells the half.
        float lo = i == 0 ? -f.reach : w;
        float hi = i == 0 ? -w : f.reach;
        float found = bracketedNewtonRun(f, true, lo, hi, true, wanted);
        minima[0] = i == 0 ? found : minima[0];
        minima[1] = i == 0 ? minima[1] : found;
    }
    state.firstMinimum = hasLeft ? minima[0] : minima[1];
    state.secondMinimum = hasRight ? minima[1] : minima[0];
    TORUS_PRECISE float middle = -(state.firstMinimum + state.secondMinimum);
    state.middle = middle;
    // The inner sheet of a spindle has roots too, in the same dip, further in; it never has a dip of its own.
    state.first = quarticValue(f, state.firstMinimum) <= 0.0;
    state.second = quarticValue(f, state.secondMinimum) <= 0.0;
    state.joined = !state.two || (state.first && state.second && quarticValue(f, middle) <= 0.0);
    return state;
}

// Crossing `index`: 0 into, 1 out of the first dip; 2 into, 3 out of the second. Of joined dips 0 and 3.
bool bracketedNewtonRoot(torus_Line line, BracketedNewton state, int index, out float u) {
    bool atFirst = index < 2;
    bool inner = index == 1 || index == 2;
    bool leaves = index == 1 || index == 3;
    float minimum = atFirst ? state.firstMinimum : state.secondMinimum;
    float far = inner ? state.middle : (atFirst ? -state.f.reach : state.f.reach);
    bool exists = (atFirst ? state.first : state.second) && !(inner && state.joined);
    u = bracketedNewtonRun(state.f, false, leaves ? minimum : far, leaves ? far : minimum, leaves, exists);
    TORUS_PRECISE float sheet = u * u + state.f.k;
    return exists && sheet >= 0.0;
}

#define QUARTIC_INTERSECT bracketedNewtonIntersect
#define QUARTIC_OCCLUDED bracketedNewtonOccluded
#define QUARTIC_INTERSECT_ALL bracketedNewtonIntersectAll
#define QUARTIC_STATE BracketedNewton
#define QUARTIC_PREPARE bracketedNewtonPrepare
#define QUARTIC_ROOT bracketedNewtonRoot
#define QUARTIC_DIPS
#include "parts/quartic_hits.glsl"

#define RAY_INTERSECT bracketedNewtonIntersect
#define RAY_OCCLUDED bracketedNewtonOccluded
#define RAY_INTERSECT_ALL bracketedNewtonIntersectAll

#endif
