// SPDX-License-Identifier: MIT
// Method: what everybody pastes: the quartic in world space by its formula, tuned.
// Tolerance: 2e-3 (R + r).
//
// What everybody pastes, fairly tuned: the quartic of the ray in world space in plain float32, no arrays where one hit is
// wanted, one cube root, the bounding sphere first. closed_form_naive.glsl is the same mathematics as it is written
// without thought of speed.
//
// With a unit direction, n = o.d, m = |o|^2 and k = (m - R^2 - r^2) / 2 the quartic is
// t^4 + 4 k3 t^3 + 4 k2 t^2 + 8 k1 t + 4 k0; t = y - k3 leaves y^4 + p y^2 + q y + s. Ferrari and Descartes: it is
// (y^2 + a y + b)(y^2 - a y + c), a^2 = v - 2 p / 3, v the largest root of v^3 - 3 Q v - 2 H (van der Waerden, Algebra I,
// section 64), by Cardano for two roots and by Vieta's trigonometric form for four (Press et al., Numerical Recipes,
// section 5.6). Where q vanishes the reversed polynomial, whose roots are the reciprocals, is solved instead.
//
// What it loses: from afar the coefficients hold the fourth power of the distance, and no torus any more.
#ifndef CLOSED_FORM_COMMON_GLSL
#define CLOSED_FORM_COMMON_GLSL

#include "torus/torus.glsl"

// Below this part of (R + r)^3, q / 8 counts as zero.
#define COMMON_FORM_REVERSE 0.01

struct CommonForm {
    vec3 direction;      // unit
    float size;          // length of the direction as given
    float perSize;
    float n;
    float square;        // |origin|^2
};

// What every ray needs. False where there is no root: bad input, past the bounding sphere or behind it.
bool commonFormMeets(Torus torus, vec3 o, float tMin, vec3 direction, float tMax, out CommonForm f) {
    float reach = torus.majorRadius + torus.minorRadius;
    float size2 = dot(direction, direction);
    f.perSize = inversesqrt(size2);
    f.size = size2 * f.perSize;
    f.direction = direction * f.perSize;
    f.n = dot(o, f.direction);
    f.square = dot(o, o);
    float outside = f.square - reach * reach;
    bool valid = size2 > 0.0 && size2 <= TORUS_FLOAT_MAX && torus.minorRadius > 0.0 && torus.majorRadius >= 0.0 &&
                 reach <= TORUS_FLOAT_MAX && tMin <= tMax;
    return valid && f.n * f.n >= outside && (outside <= 0.0 || f.n <= -tMin * f.size);
}

struct CommonRoots {
    bool real;
    float sheet;         // |p|^2 + R^2 - r^2 = t (t + 2 n) + sheet, not negative on the outer sheet
    bool reversed;
    float shift;
    float side;          // a / 2 with the sign of q
    float leftSquare;    // a quarter of the discriminants of the two quadratics
    float rightSquare;
};

CommonRoots commonFormSolve(Torus torus, vec3 o, CommonForm f) {
    CommonRoots roots;
    float R2 = torus.majorRadius * torus.majorRadius;
    float r2 = torus.minorRadius * torus.minorRadius;
    float reach = torus.majorRadius + torus.minorRadius;
    float n = f.n;
    roots.sheet = f.square + R2 - r2;
    float k = 0.5 * (f.square - R2 - r2);
    float k3 = n;
    float k2 = n * n + R2 * f.direction.z * f.direction.z + k;
    float k1 = k * n + R2 * o.z * f.direction.z;
    float k0 = k * k + R2 * (o.z * o.z - r2);
    float q8 = k3 * (k3 * k3 - k2) + k1;
    roots.reversed = abs(q8) < COMMON_FORM_REVERSE * reach * reach * reach;
    if (roots.reversed) {
        float perK0 = 0.25 / k0;
        float swap = k1;
        k1 = 0.5 * k3 * perK0;
        k3 = 2.0 * swap * perK0;
        k2 = k2 * perK0;
        k0 = 0.25 * perK0;
        q8 = k3 * (k3 * k3 - k2) + k1;
    }
    float p = 4.0 * k2 - 6.0 * k3 * k3;
    float q = 8.0 * q8;
    float s = k3 * (k3 * (4.0 * k2 - 3.0 * k3 * k3) - 8.0 * k1) + 4.0 * k0;
    float Q = (p * p + 12.0 * s) * (1.0 / 9.0);
    float H = (p * (2.0 * p * p - 72.0 * s) + 27.0 * q * q) * (1.0 / 54.0);
    float discriminant = H * H - Q * Q * Q;
    float v;
    if (discriminant >= 0.0) {
        float cube = pow(abs(H) + sqrt(discriminant), 1.0 / 3.0);
        v = sign(H) * (cube + Q / cube);
    } else {
        float root = sqrt(Q);
        v = 2.0 * root * cos(acos(clamp(H / (Q * root), -1.0, 1.0)) * (1.0 / 3.0));
    }
    float a2 = v - (2.0 / 3.0) * p;
    float a = sqrt(a2);
    float ratio = 0.5 * abs(q) / a;
    float base = -0.25 * a2 - 0.5 * p;
    roots.side = q < 0.0 ? -0.5 * a : 0.5 * a;
    roots.leftSquare = base + ratio;
    roots.rightSquare = base - ratio;
    roots.shift = k3;
    roots.real = a2 > 0.0 && roots.leftSquare >= 0.0;
    return roots;
}

// Root 0 to 3, in lengths of the unit direction; TORUS_FLOAT_MAX if it is none, or no hit.
float commonFormRoot(CommonForm f, CommonRoots roots, float tMin, float tMax, int index) {
    bool left = index < 2;
    float square = left ? roots.leftSquare : roots.rightSquare;
    float width = sqrt(max(square, 0.0));
    float y = (left ? -roots.side : roots.side) + ((index & 1) == 0 ? -width : width) - roots.shift;
    float t = roots.reversed ? 1.0 / y : y;
    bool hit = square >= 0.0 && t >= tMin * f.size && t <= tMax * f.size && t * (t + 2.0 * f.n) + roots.sheet >= 0.0;
    return hit ? t : TORUS_FLOAT_MAX;
}

float commonFormFirst(CommonForm f, CommonRoots roots, float tMin, float tMax) {
    float first = min(commonFormRoot(f, roots, tMin, tMax, 0), commonFormRoot(f, roots, tMin, tMax, 1));
    if (roots.rightSquare >= 0.0) {
        first = min(first, min(commonFormRoot(f, roots, tMin, tMax, 2), commonFormRoot(f, roots, tMin, tMax, 3)));
    }
    return first;
}

TorusHit commonFormHit(CommonForm f, vec3 origin, float t) {
    return TorusHit(t * f.perSize, origin + t * f.direction);
}

bool commonFormIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    CommonForm f;
    if (commonFormMeets(torus, origin, tMin, direction, tMax, f)) {
        CommonRoots roots = commonFormSolve(torus, origin, f);
        if (roots.real) {
            float t = commonFormFirst(f, roots, tMin, tMax);
            hits = t < TORUS_FLOAT_MAX;
            if (hits) {
                nearest = commonFormHit(f, origin, t);
            }
        }
    }
    hit = nearest;
    return hits;
}

bool commonFormOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    bool hits = false;
    CommonForm f;
    if (commonFormMeets(torus, origin, tMin, direction, tMax, f)) {
        CommonRoots roots = commonFormSolve(torus, origin, f);
        if (roots.real) {
            hits = commonFormFirst(f, roots, tMin, tMax) < TORUS_FLOAT_MAX;
        }
    }
    return hits;
}

int commonFormIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    CommonForm f;
    if (commonFormMeets(torus, origin, tMin, direction, tMax, f)) {
        CommonRoots roots = commonFormSolve(torus, origin, f);
        if (roots.real) {
            float a = commonFormRoot(f, roots, tMin, tMax, 0);
            float b = commonFormRoot(f, roots, tMin, tMax, 1);
            float c = commonFormRoot(f, roots, tMin, tMax, 2);
            float d = commonFormRoot(f, roots, tMin, tMax, 3);
            // A sorting network: pairs, then the ends, then the middle. What is no hit goes last.
            vec2 ab = vec2(min(a, b), max(a, b));
            vec2 cd = vec2(min(c, d), max(c, d));
            float upper = max(ab.x, cd.x);
            float lower = min(ab.y, cd.y);
            float sorted[4] = float[4](min(ab.x, cd.x), min(upper, lower), max(upper, lower), max(ab.y, cd.y));
            for (int i = 0; i < 4; ++i) {
                if (sorted[i] < TORUS_FLOAT_MAX) {
                    hits[i] = commonFormHit(f, origin, sorted[i]);
                    ++count;
                }
            }
        }
    }
    return count;
}

#define RAY_INTERSECT commonFormIntersect
#define RAY_OCCLUDED commonFormOccluded
#define RAY_INTERSECT_ALL commonFormIntersectAll

#endif
