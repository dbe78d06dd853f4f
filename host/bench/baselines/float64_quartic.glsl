// SPDX-License-Identifier: MIT
// Baseline: bracketed Newton on the reduced quartic in float64.
// Needs: float64.
//
// Exactness bought with float64, as who has it would write it: the ray moved to the foot of the perpendicular, the
// reduced quartic f(u) = u^4 + p u^2 + q u + s of parts/reduced_quartic.glsl in doubles, its critical points and roots by
// bracketed Newton (bracketed_newton.glsl), no compensation and no last step. A bounding sphere in float32 comes first.
// GLSL has no cos, acos or pow of doubles, so a closed form is out of reach.
#ifndef FLOAT64_QUARTIC_GLSL
#define FLOAT64_QUARTIC_GLSL

#include "torus/torus.glsl"

#define FLOAT64_STEPS 64
// A step shorter than this part of r is the last one: Newton's next is its square.
#define FLOAT64_ENOUGH 1.0e-6lf
// Room for the float32 bounding sphere, in distances of the origin: what the vector to the closest point rounds by.
#define FLOAT64_ROOM 5.0e-7

struct Float64Line {
    dvec3 foot;
    dvec3 direction;
    double footT;
    double p;
    double q;
    double s;
    double k;          // outer sheet where u^2 + k >= 0
    double reach;
    double enough;
    double minima[2];
    double middle;
    bool dips[2];      // f is negative at the minimum
    bool joined;
};

double float64Value(Float64Line f, double u) {
    return ((u * u + f.p) * u + f.q) * u + f.s;
}

// The root of f, or of f' / 4, between lo and hi, where it rises if `rising`, else falls.
double float64Run(Float64Line f, bool derivative, double lo, double hi, bool rising, bool wanted) {
    double u = 0.5lf * (lo + hi);
    bool busy = wanted;
    for (int i = 0; i < FLOAT64_STEPS && busy; ++i) {
        double cubic = (u * u + 0.5lf * f.p) * u + 0.25lf * f.q;
        double value = derivative ? cubic : float64Value(f, u);
        double slope = derivative ? 3.0lf * u * u + 0.5lf * f.p : 4.0lf * cubic;
        bool beyond = (value > 0.0lf) == rising;
        lo = beyond ? lo : u;
        hi = beyond ? u : hi;
        double newton = u - value / slope;
        double next = newton >= lo && newton <= hi ? newton : 0.5lf * (lo + hi);
        busy = abs(next - u) > f.enough;
        u = next;
    }
    return u;
}

bool float64Solve(Torus torus, vec3 origin, vec3 direction, out Float64Line f) {
    float reach = torus.majorRadius + torus.minorRadius;
    float perDd = 1.0 / dot(direction, direction);
    vec3 away = origin - dot(origin, direction) * perDd * direction;
    float roomy = reach + FLOAT64_ROOM * (reach + sqrt(dot(origin, origin)));
    if (!(dot(away, away) <= roomy * roomy)) {
        return false;
    }
    double R = double(torus.majorRadius);
    double r = double(torus.minorRadius);
    dvec3 o = dvec3(origin);
    f.direction = dvec3(direction);
    double dd = dot(f.direction, f.direction);
    f.footT = -dot(o, f.direction) / dd;
    f.foot = o + f.footT * f.direction;
    double foot2 = dot(f.foot, f.foot);
    double chord2 = (R + r) * (R + r) - foot2;
    f.reach = sqrt(max(chord2, 0.0lf) / dd);
    f.enough = FLOAT64_ENOUGH * r / sqrt(dd);
    f.k = (foot2 + R * R - r * r) / dd;
    double scale = -4.0lf * R * R / (dd * dd);
    f.p = 2.0lf * f.k + scale * dot(f.direction.xy, f.direction.xy);
    f.q = 2.0lf * scale * dot(f.foot.xy, f.direction.xy);
    f.s = f.k * f.k + scale * dot(f.foot.xy, f.foot.xy);
    double w = sqrt(max(f.p / -6.0lf, 0.0lf));
    double edge = 2.0lf * w * w * w;
    bool hasLeft = 0.25lf * f.q + edge > 0.0lf;
    bool hasRight = 0.25lf * f.q - edge < 0.0lf || !hasLeft;
    double left = float64Run(f, true, -f.reach, -w, true, hasLeft);
    double right = float64Run(f, true, w, f.reach, true, hasRight);
    f.minima[0] = hasLeft ? left : right;
    f.minima[1] = hasRight ? right : left;
    f.middle = -(f.minima[0] + f.minima[1]);
    f.dips[0] = float64Value(f, f.minima[0]) <= 0.0lf;
    f.dips[1] = float64Value(f, f.minima[1]) <= 0.0lf;
    f.joined = !(hasLeft && hasRight) || (f.dips[0] && f.dips[1] && float64Value(f, f.middle) <= 0.0lf);
    return chord2 > 0.0lf && (f.dips[0] || f.dips[1]);
}

// Crossing `index`: 0 into, 1 out of the first dip; 2 into, 3 out of the second. Of joined dips 0 and 3.
bool float64Root(Float64Line f, int index, float tMin, float tMax, out double u) {
    int dip = index >> 1;
    bool inner = index == 1 || index == 2;
    bool leaves = (index & 1) == 1;
    double minimum = dip == 0 ? f.minima[0] : f.minima[1];
    double far = inner ? f.middle : (dip == 0 ? -f.reach : f.reach);
    bool exists = (dip == 0 ? f.dips[0] : f.dips[1]) && !(inner && f.joined);
    u = float64Run(f, false, leaves ? minimum : far, leaves ? far : minimum, leaves, exists);
    double t = f.footT + u;
    return exists && u * u + f.k >= 0.0lf && t >= double(tMin) && t <= double(tMax);
}

TorusHit float64Hit(Float64Line f, double u) {
    return TorusHit(float(f.footT + u), vec3(f.foot + u * f.direction));
}

bool float64Intersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = torus_miss(tMax);
    Float64Line f;
    if (!float64Solve(torus, origin, direction, f)) {
        return false;
    }
    bool found = false;
    double u = 0.0lf;
    for (int i = 0; i < 4 && !found; ++i) {
        found = float64Root(f, i, tMin, tMax, u);
    }
    if (found) {
        hit = float64Hit(f, u);
    }
    return found;
}

// A dip whose bottom lies on the ray is a hit without a root; else an end of the ray lies in a dip, or no hit does.
bool float64Occluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    Float64Line f;
    if (!float64Solve(torus, origin, direction, f)) {
        return false;
    }
    double lower = max(double(tMin) - f.footT, -f.reach);
    double upper = min(double(tMax) - f.footT, f.reach);
    bool insideLower = lower > -f.reach && float64Value(f, lower) < 0.0lf;
    bool insideUpper = upper < f.reach && float64Value(f, upper) < 0.0lf;
    bool dip = (f.dips[0] && f.minima[0] >= lower && f.minima[0] <= upper) ||
               (f.dips[1] && f.minima[1] >= lower && f.minima[1] <= upper);
    bool gap = f.dips[0] && f.dips[1] && !f.joined && lower < f.middle && upper > f.middle;
    return lower <= upper && (insideLower != insideUpper || (insideLower ? gap : dip));
}

int float64IntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    Float64Line f;
    if (!float64Solve(torus, origin, direction, f)) {
        return 0;
    }
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        double u;
        if (float64Root(f, i, tMin, tMax, u)) {
            hits[count] = float64Hit(f, u);
            ++count;
        }
    }
    return count;
}

#define RAY_INTERSECT float64Intersect
#define RAY_OCCLUDED float64Occluded
#define RAY_INTERSECT_ALL float64IntersectAll

#endif
