// SPDX-License-Identifier: MIT
// Method: the quartic in world space by its formula, as it is usually written.
// Tolerance: 2e-3 (R + r).
//
// What most shaders do: the quartic of the ray as it stands in world space, solved by formula in plain float32, with the
// driver's acos, cos and pow. Kept as it is usually written, because it is the measure of speed and the reason
// why exactness is worth something: from 100 R away the coefficients, which hold the fourth power of the distance, have
// lost the torus.
//
// Ferrari's and Descartes' factoring of a depressed quartic into two quadratics by a root of the resolvent cubic
// (van der Waerden, Algebra I, section 64), the cubic by Cardano or Vieta's trigonometric form (Press et al., Numerical
// Recipes, section 5.6). Where the depressed linear coefficient vanishes and the factoring would divide by it, the
// reversed polynomial, whose roots are the reciprocals, is solved instead.
#ifndef CLOSED_FORM_NAIVE_GLSL
#define CLOSED_FORM_NAIVE_GLSL

#include "torus/torus.glsl"

// t^4 + c3 t^3 + c2 t^2 + c1 t + c0
struct NaiveQuartic {
    float c3;
    float c2;
    float c1;
    float c0;
};

// Below this part of (R + r)^3 the depressed linear coefficient counts as zero.
#define NAIVE_REVERSE 0.01

float naiveCubeRoot(float x) {
    return sign(x) * pow(abs(x), 1.0 / 3.0);
}

// y^3 + p y + q = 0: its largest real root.
float naiveCubic(float p, float q) {
    float third = -p / 3.0;
    float halfQ = -0.5 * q;
    float discriminant = halfQ * halfQ - third * third * third;
    if (discriminant < 0.0) {
        float root = sqrt(third);
        return 2.0 * root * cos(acos(clamp(halfQ / (root * third), -1.0, 1.0)) / 3.0);
    }
    float root = sqrt(discriminant);
    return naiveCubeRoot(halfQ + root) + naiveCubeRoot(halfQ - root);
}

// y, with t = y - c3 / 4, of the depressed quartic y^4 + p y^2 + q y + s.
vec3 naiveDepress(NaiveQuartic f) {
    float a = 0.25 * f.c3;
    float a2 = a * a;
    float p = f.c2 - 6.0 * a2;
    float q = f.c1 - 2.0 * a * f.c2 + 8.0 * a * a2;
    float s = f.c0 - a * f.c1 + a2 * f.c2 - 3.0 * a2 * a2;
    return vec3(p, q, s);
}

// The real roots, in no order; returns their number. `small` is what counts as zero.
int naiveQuartic(NaiveQuartic f, float small, out float roots[4]) {
    roots = float[4](0.0, 0.0, 0.0, 0.0);
    vec3 depressed = naiveDepress(f);
    bool reversed = abs(depressed.y) < small;
    if (reversed) {
        f = NaiveQuartic(f.c1 / f.c0, f.c2 / f.c0, f.c3 / f.c0, 1.0 / f.c0);
        depressed = naiveDepress(f);
    }
    float p = depressed.x;
    float q = depressed.y;
    float s = depressed.z;
    // (y^2 + a y + b)(y^2 - a y + c): a^2 is a root of w^3 + 2 p w^2 + (p^2 - 4 s) w - q^2.
    float w = naiveCubic(-p * p / 3.0 - 4.0 * s, -2.0 * p * p * p / 27.0 + 8.0 * p * s / 3.0 - q * q) - 2.0 * p / 3.0;
    if (!(w > 0.0)) {
        return 0;
    }
    float a = sqrt(w);
    float shift = 0.25 * f.c3;
    int count = 0;
    for (int i = 0; i < 2; ++i) {
        float side = i == 0 ? 0.5 : -0.5;
        float discriminant = -0.25 * w - 0.5 * p + side * q / a;
        if (discriminant >= 0.0) {
            float root = sqrt(discriminant);
            float low = -side * a - root - shift;
            float high = -side * a + root - shift;
            roots[count] = reversed ? 1.0 / low : low;
            roots[count + 1] = reversed ? 1.0 / high : high;
            count += 2;
        }
    }
    return count;
}

// Every t of a hit in [tMin, tMax], ascending, in lengths of the unit direction.
int naiveRoots(Torus torus, vec3 origin, float tMin, vec3 d, float tMax, out float hits[4]) {
    hits = float[4](0.0, 0.0, 0.0, 0.0);
    float R2 = torus.majorRadius * torus.majorRadius;
    float reach = torus.majorRadius + torus.minorRadius;
    float n = dot(origin, d);
    float m = dot(origin, origin);
    if (n * n - m + reach * reach < 0.0) {
        return 0;
    }
    // (|p|^2 - R^2 - r^2)^2 + 4 R^2 (z^2 - r^2): less cancels than in the form with rho.
    float r2 = torus.minorRadius * torus.minorRadius;
    float k = 0.5 * (m - R2 - r2);
    NaiveQuartic f = NaiveQuartic(4.0 * n, 4.0 * (n * n + k + R2 * d.z * d.z), 8.0 * (n * k + R2 * origin.z * d.z),
                                  4.0 * (k * k + R2 * (origin.z * origin.z - r2)));
    float roots[4];
    int rootCount = naiveQuartic(f, NAIVE_REVERSE * reach * reach * reach, roots);
    int count = 0;
    for (int i = 0; i < rootCount; ++i) {
        float t = roots[i];
        // On the outer sheet |p|^2 + R^2 - r^2 = 2 R rho is not negative.
        if (t >= tMin && t <= tMax && t * (t + 2.0 * n) + m + R2 - r2 >= 0.0) {
            int at = count;
            for (; at > 0 && hits[at - 1] > t; --at) {
                hits[at] = hits[at - 1];
            }
            hits[at] = t;
            ++count;
        }
    }
    return count;
}

// Every hit as naiveRoots has it; false where the input is bad.
bool naiveHits(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out vec3 unit, out float perLength,
              out float roots[4], out int count) {
    float size = length(direction);
    perLength = 1.0 / size;
    unit = direction * perLength;
    roots = float[4](0.0, 0.0, 0.0, 0.0);
    count = 0;
    if (!(size > 0.0 && size <= TORUS_FLOAT_MAX && torus.minorRadius > 0.0 && torus.majorRadius >= 0.0 &&
          tMin <= tMax)) {
        return false;
    }
    count = naiveRoots(torus, origin, tMin * size, unit, tMax * size, roots);
    return true;
}

bool naiveIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = torus_miss(tMax);
    vec3 unit;
    float perLength;
    float roots[4];
    int count;
    if (!naiveHits(torus, origin, tMin, direction, tMax, unit, perLength, roots, count) || count == 0) {
        return false;
    }
    hit = TorusHit(roots[0] * perLength, origin + roots[0] * unit);
    return true;
}

bool naiveOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    vec3 unit;
    float perLength;
    float roots[4];
    int count;
    return naiveHits(torus, origin, tMin, direction, tMax, unit, perLength, roots, count) && count > 0;
}

int naiveIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    vec3 unit;
    float perLength;
    float roots[4];
    int count;
    if (!naiveHits(torus, origin, tMin, direction, tMax, unit, perLength, roots, count)) {
        return 0;
    }
    for (int i = 0; i < count; ++i) {
        hits[i] = TorusHit(roots[i] * perLength, origin + roots[i] * unit);
    }
    return count;
}

#define RAY_INTERSECT naiveIntersect
#define RAY_OCCLUDED naiveOccluded
#define RAY_INTERSECT_ALL naiveIntersectAll

#endif
