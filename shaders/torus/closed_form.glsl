// SPDX-License-Identifier: MIT
//
// The closed form: from the equation of the torus to the roots by radicals, one function a step, each with the number
// of its equation in docs/math.md. To read, to compare with, to teach: not what torusIntersect does.
//
//   - It has the roots of the polynomial on the whole line: of a spindle those of the inner sheet, too.
//   - Its float32 answers are only sometimes good, which is why the library finds its hits otherwise. The inner root S
//     is the square root of a difference: where it is small, near the planes of symmetry, and near a double root t is
//     right to half the digits, off by up to 1e-3 R. And the number of roots is wrong for some of the lines that pass
//     within 1e-7 r / w^2 of a tangent: at r = 0.01 R one in 500, at 0.25 R none of thousands. In 113 bits the same
//     lines are right to 1e-15 R on every ray, tangents included, but for the axis of a horn: 1e-8 R.
//     tests/closed_form/closed_form_test.cpp and closed_form_float_test.cpp measure both.
//   - Nothing non-finite comes out, whatever finite numbers go in. Only + - * / sqrt, comparisons and bit patterns.
//
// Includes torus.glsl. Symbols in the code are those of the derivation: a, b, c; x, y, z; alpha to zeta.
#ifndef TORUS_CLOSED_FORM_GLSL
#define TORUS_CLOSED_FORM_GLSL

#include "torus.glsl"

// Beyond this r / R a torus is a sphere to a hundredth, and gamma^2 outgrows what float32 can tell apart.
#define TORUS_CLOSED_FORM_WIDEST 100.0

// Steps that bring 113 bits from the starts below; float32 needs two of each.
#define TORUS_CUBE_ROOT_STEPS 3
#define TORUS_THIRD_COSINE_STEPS 4

// A ray brought to R = 1 and to its point closest to the centre (math.md, eq. 8).
struct TorusReducedRay {
    vec3 origin;       // (a, b, c): perpendicular to the direction
    vec3 direction;    // (x, y, z): unit
    float tubeRadius;  // w = r / R
    float shift;       // t of the ray = shift + scale * t of the reduced ray
    float scale;
};

// t^4 + 2 alpha t^2 + 8 cz t + beta (math.md, eq. 9).
struct TorusReducedQuartic {
    float alpha;
    float cz;          // c z, which is -(a x + b y)
    float beta;
};

// The quartic of any ray, in the ray's own t, as it stands (math.md, eq. 7):
//     c[0] + c[1] t + c[2] t^2 + c[3] t^3 + c[4] t^4
//
// torus, origin, direction   numbers up to 1e9, beyond which float32 does not hold their fourth powers
// c          the coefficients; 0 where a number is larger or NaN. Far from the torus they have lost it: c[0] is about
//            |origin|^4.
void torusQuarticCoefficients(Torus torus, vec3 origin, vec3 direction, out float c[5]) {
    for (int i = 0; i < 5; ++i) {
        c[i] = 0.0;
    }
    bool fits = abs(torus.majorRadius) <= 1.0e9 && abs(torus.minorRadius) <= 1.0e9 && abs(origin.x) <= 1.0e9 &&
                abs(origin.y) <= 1.0e9 && abs(origin.z) <= 1.0e9 && abs(direction.x) <= 1.0e9 &&
                abs(direction.y) <= 1.0e9 && abs(direction.z) <= 1.0e9;
    if (!fits) {
        return;
    }
    TORUS_PRECISE float r2 = torus.majorRadius * torus.majorRadius;
    TORUS_PRECISE float w2 = torus.minorRadius * torus.minorRadius;
    TORUS_PRECISE float a2 = origin.x * origin.x;
    TORUS_PRECISE float b2 = origin.y * origin.y;
    TORUS_PRECISE float c2 = origin.z * origin.z;
    TORUS_PRECISE float x2 = direction.x * direction.x;
    TORUS_PRECISE float y2 = direction.y * direction.y;
    TORUS_PRECISE float z2 = direction.z * direction.z;
    TORUS_PRECISE float ax = origin.x * direction.x;
    TORUS_PRECISE float by = origin.y * direction.y;
    TORUS_PRECISE float cz = origin.z * direction.z;
    TORUS_PRECISE float o2 = a2 + b2 + c2;
    TORUS_PRECISE float d2 = x2 + y2 + z2;
    TORUS_PRECISE float inPlane = o2 - r2 - w2;
    TORUS_PRECISE float alongAxis = o2 + r2 - w2;
    // The 15 terms of t^0 are a difference of two squares (math.md, eq. 3 at the origin).
    TORUS_PRECISE float c0 = alongAxis * alongAxis - 4.0 * r2 * (a2 + b2);
    TORUS_PRECISE float c1 = 4.0 * (inPlane * (ax + by) + alongAxis * cz);
    TORUS_PRECISE float quadratic = 2.0 * ((c2 - r2 - w2) * (x2 + y2) + 4.0 * by * cz + (3.0 * c2 + r2 - w2) * z2 +
                                           4.0 * ax * (by + cz) + a2 * (3.0 * x2 + y2 + z2) +
                                           b2 * (x2 + 3.0 * y2 + z2));
    TORUS_PRECISE float c3 = 4.0 * (ax + by + cz) * d2;
    TORUS_PRECISE float c4 = d2 * d2;
    c[0] = c0;
    c[1] = c1;
    c[2] = quadratic;
    c[3] = c3;
    c[4] = c4;
}

// Moves the origin to the point closest to the centre, which takes the cubic term away, and scales to R = 1 and a unit
// direction (math.md, eq. 8). The shift is ray.glsl's, exact from 10^8 R, too.
//
// returns    false, and zeros, where the ray passes the bounding sphere by, for bad input as in torus.glsl, for R = 0
//            and for r > 100 R
bool torusReduceRay(Torus torus, vec3 origin, vec3 direction, out TorusReducedRay ray) {
    ray = TorusReducedRay(vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, 0.0), 0.0, 0.0, 0.0);
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, -TORUS_FLOAT_MAX, direction,
                                   TORUS_FLOAT_MAX);
    TORUS_PRECISE float widest = TORUS_CLOSED_FORM_WIDEST * line.majorRadius;
    bool meets = line.meets && line.minorRadius <= widest;
    if (meets) {
        TORUS_PRECISE float shift = (line.baseShift + line.shift) * line.tPerU;
        TORUS_PRECISE float invLength = 1.0 / sqrt(line.length2);
        TORUS_PRECISE float invMajor = 1.0 / line.majorRadius;
        TORUS_PRECISE vec3 foot = line.foot * invMajor;
        TORUS_PRECISE vec3 unit = line.direction * invLength;
        TORUS_PRECISE float tubeRadius = line.minorRadius * invMajor;
        TORUS_PRECISE float scale = line.majorRadius * invLength * line.tPerU;
        TORUS_PRECISE float largest = abs(shift) + (1.0 + tubeRadius) * scale;
        meets = largest <= TORUS_FLOAT_MAX;  // no t is beyond float32
        if (meets) {
            ray = TorusReducedRay(foot, unit, tubeRadius, shift, scale);
        }
    }
    return meets;
}

// beta as the sum that the derivation arrives at (math.md, eq. 11): in float32 its terms cancel beside a thin tube.
float torusBetaSum(TorusReducedRay ray) {
    TORUS_PRECISE float a2 = ray.origin.x * ray.origin.x;
    TORUS_PRECISE float b2 = ray.origin.y * ray.origin.y;
    TORUS_PRECISE float c2 = ray.origin.z * ray.origin.z;
    TORUS_PRECISE float w2 = ray.tubeRadius * ray.tubeRadius;
    TORUS_PRECISE float beta = a2 * a2 + 2.0 * b2 * a2 + 2.0 * c2 * a2 - 2.0 * w2 * a2 - 2.0 * a2 + b2 * b2 + c2 * c2 +
                               w2 * w2 - 2.0 * b2 + 2.0 * b2 * c2 + 2.0 * c2 - 2.0 * b2 * w2 - 2.0 * c2 * w2 -
                               2.0 * w2 + 1.0;
    return beta;
}

// beta as the product of what the point is off the outer and the inner sheet (math.md, eq. 12): keeps its sign and its
// digits.
float torusBetaProduct(TorusReducedRay ray) {
    TORUS_PRECISE float c2 = ray.origin.z * ray.origin.z;
    TORUS_PRECISE float rho = sqrt(ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y);
    TORUS_PRECISE float inner = rho - 1.0;
    TORUS_PRECISE float outer = rho + 1.0;
    TORUS_PRECISE float outerSheet = (inner - ray.tubeRadius) * (inner + ray.tubeRadius) + c2;
    TORUS_PRECISE float innerSheet = (outer - ray.tubeRadius) * (outer + ray.tubeRadius) + c2;
    TORUS_PRECISE float beta = outerSheet * innerSheet;
    return beta;
}

// The reduced quartic, first version: its terms from the coordinate along the axis (math.md, eq. 9, 10).
TorusReducedQuartic torusAxialQuartic(TorusReducedRay ray) {
    TORUS_PRECISE float o2 = ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y + ray.origin.z * ray.origin.z;
    TORUS_PRECISE float w2 = ray.tubeRadius * ray.tubeRadius;
    TORUS_PRECISE float alpha = o2 - w2 + 2.0 * ray.direction.z * ray.direction.z - 1.0;
    TORUS_PRECISE float cz = ray.origin.z * ray.direction.z;
    return TorusReducedQuartic(alpha, cz, torusBetaProduct(ray));
}

// The reduced quartic, second version: from the coordinates across the axis (math.md, eq. 13). The same numbers,
// otherwise rounded.
TorusReducedQuartic torusRadialQuartic(TorusReducedRay ray) {
    TORUS_PRECISE float o2 = ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y + ray.origin.z * ray.origin.z;
    TORUS_PRECISE float w2 = ray.tubeRadius * ray.tubeRadius;
    TORUS_PRECISE float alpha = o2 - w2 - 2.0 * ray.direction.x * ray.direction.x -
                                2.0 * ray.direction.y * ray.direction.y + 1.0;
    TORUS_PRECISE float cz = -(ray.origin.x * ray.direction.x + ray.origin.y * ray.direction.y);
    return TorusReducedQuartic(alpha, cz, torusBetaProduct(ray));
}

// Private: the cube root, 0 for |x| < 1e-37. A third of the exponent, and of the mantissa by the way, is right to some
// 4 % (Kahan, Computing a Real Cube Root, 1991); each step of Halley's method cubes the error.
float torus_cubeRoot(float x) {
    float size = abs(x);
    TORUS_PRECISE float root = uintBitsToFloat(floatBitsToUint(size) / 3u + 0x2a5119f2u);
    for (int i = 0; i < TORUS_CUBE_ROOT_STEPS; ++i) {
        TORUS_PRECISE float cube = root * root * root;
        root = root * (cube + 2.0 * size) / (2.0 * cube + size);
    }
    if (!(size >= 1.0e-37)) {
        root = 0.0;
    }
    return x < 0.0 ? -root : root;
}

// Private: cos(theta / 3) of an angle in [0, pi] from s = cos(theta / 2) in [0, 1], without trigonometry. k = cos(theta
// / 6) solves 4 k^3 - 3 k = s (Vieta's form of the cubic with three real roots; Nickalls, The Mathematical Gazette 77,
// 1993, pp. 354-359) and lies in [sqrt(3) / 2, 1], where that cubic is steep: Newton needs no care. Of theta itself the
// same cubic has a double root at theta = pi.
float torus_thirdCosine(float s) {
    TORUS_PRECISE float k = 0.8660254 + 0.1339746 * s;  // the chord: off by 0.007
    for (int i = 0; i < TORUS_THIRD_COSINE_STEPS; ++i) {
        TORUS_PRECISE float k2 = k * k;
        k = k - ((4.0 * k2 - 3.0) * k - s) / (12.0 * k2 - 3.0);
    }
    TORUS_PRECISE float cosine = 2.0 * k * k - 1.0;
    return cosine;
}

// Private: gamma and delta (math.md, eq. 15) and epsilon = gamma^2 - 4 delta^3 (math.md, eq. 17), of which the product
// of sum and difference keeps more than the difference of the squares.
struct torus_Resolvent {
    float gamma;
    float delta;
    float edge;     // 2 delta^(3/2): epsilon is negative for |gamma| < edge
    float epsilon;
};

torus_Resolvent torus_resolvent(TorusReducedQuartic f) {
    TORUS_PRECISE float alpha2 = f.alpha * f.alpha;
    TORUS_PRECISE float gamma = 16.0 * alpha2 * f.alpha - 144.0 * f.beta * f.alpha + 1728.0 * f.cz * f.cz;
    TORUS_PRECISE float delta = 4.0 * alpha2 + 12.0 * f.beta;
    TORUS_PRECISE float edge = delta > 0.0 ? 2.0 * delta * sqrt(delta) : 0.0;
    TORUS_PRECISE float epsilon =
        delta > 0.0 ? (gamma - edge) * (gamma + edge) : gamma * gamma - 4.0 * delta * delta * delta;
    return torus_Resolvent(gamma, delta, edge, epsilon);
}

// Private: y for epsilon < 0, where zeta is complex and y = (zeta + its conjugate) / 3 (math.md, eq. 21).
float torus_complexCase(torus_Resolvent g) {
    TORUS_PRECISE float s = sqrt(max(0.5 * (g.gamma + g.edge) / g.edge, 0.0));
    TORUS_PRECISE float y = 2.0 * sqrt(g.delta) * torus_thirdCosine(min(s, 1.0)) / 3.0;
    return y;
}

// Private: gamma + sqrt(epsilon), or gamma - sqrt(epsilon) where that does not cancel. zeta from the one is delta /
// zeta from the other, so y is the same; but delta = 0 with gamma < 0 would give zeta = 0.
float torus_zetaCube(torus_Resolvent g) {
    TORUS_PRECISE float root = sqrt(max(g.epsilon, 0.0));
    TORUS_PRECISE float cube = g.gamma < 0.0 ? g.gamma - root : g.gamma + root;
    return cube;
}

// Private: zeta where it is real, epsilon >= 0 (math.md, eq. 18, 19). The halving may be done under the cube root (part
// = 1/2) or after it (part = 1).
float torus_zeta(torus_Resolvent g, float part) {
    TORUS_PRECISE float cube = part * torus_zetaCube(g);
    return torus_cubeRoot(cube);
}

// Private: y = zeta / (3 k) + k delta / (3 zeta), k^3 = 2 part; for epsilon < 0 the same without zeta (math.md, eq. 18,
// 19, 21).
float torus_resolventRoot(torus_Resolvent g, float part, float k) {
    if (g.epsilon < 0.0) {
        return torus_complexCase(g);
    }
    float zeta = torus_zeta(g, part);
    // zeta = 0 takes gamma = delta = 0: a triple root of the resolvent, y = 0.
    TORUS_PRECISE float y = zeta != 0.0 ? zeta / (3.0 * k) + k * g.delta / (3.0 * zeta) : 0.0;
    return y;
}

// Private: the square of the inner root S (math.md, eq. 20). Rounding can make it negative.
float torus_innerSquare(TorusReducedQuartic f, float y) {
    TORUS_PRECISE float inner = y - 4.0 * f.alpha / 3.0;
    return inner;
}

// Private: adds the roots middle -+ sqrt(square), if they are real, in their places among the roots found.
void torus_addPair(float middle, float square, inout float roots[4], inout int count) {
    if (!(square >= 0.0)) {
        return;
    }
    TORUS_PRECISE float width = sqrt(square);
    TORUS_PRECISE float lower = middle - width;
    TORUS_PRECISE float upper = middle + width;
    for (int k = 0; k < 2; ++k) {
        float root = k == 0 ? lower : upper;
        int at = count;
        for (; at > 0 && roots[at - 1] > root; --at) {
            roots[at] = roots[at - 1];
        }
        roots[at] = root;
        ++count;
    }
}

// Private: c z = 0, a quadratic in t^2 (math.md, eq. 23). Of its two roots the one that does not cancel, and beta over
// it.
int torus_biquadraticRoots(TorusReducedQuartic f, inout float roots[4]) {
    int count = 0;
    TORUS_PRECISE float discriminant = f.alpha * f.alpha - f.beta;
    if (!(discriminant >= 0.0)) {
        return 0;
    }
    TORUS_PRECISE float root = sqrt(discriminant);
    TORUS_PRECISE float larger = f.alpha > 0.0 ? -f.alpha - root : root - f.alpha;
    TORUS_PRECISE float other = larger != 0.0 ? f.beta / larger : 0.0;
    torus_addPair(0.0, larger, roots, count);
    torus_addPair(0.0, other, roots, count);
    return count;
}

// Private: the four solutions (math.md, eq. 20) from y.
int torus_pairs(TorusReducedQuartic f, float y, inout float roots[4]) {
    float inner = torus_innerSquare(f, y);
    // The inner root vanishes with c z; where rounding alone makes it negative, c z is as good as 0.
    if (f.cz == 0.0 || !(inner > 0.0)) {
        return torus_biquadraticRoots(f, roots);
    }
    TORUS_PRECISE float S = sqrt(inner);
    TORUS_PRECISE float quotient = 16.0 * f.cz / S;
    // The same number (math.md, eq. 22) without the quotient of two small ones, where it does not cancel.
    TORUS_PRECISE float sum = 2.0 * f.alpha + inner;
    TORUS_PRECISE float sum2 = sum * sum;
    TORUS_PRECISE float beta4 = 4.0 * f.beta;
    TORUS_PRECISE float square = sum2 - beta4;
    if (beta4 <= square) {
        TORUS_PRECISE float size = 2.0 * sqrt(square);
        quotient = f.cz < 0.0 ? -size : size;
    }
    TORUS_PRECISE float rest = -y - 8.0 * f.alpha / 3.0;
    TORUS_PRECISE float left = 0.25 * (rest + quotient);
    TORUS_PRECISE float right = 0.25 * (rest - quotient);
    TORUS_PRECISE float middle = 0.5 * S;
    int count = 0;
    torus_addPair(-middle, left, roots, count);
    torus_addPair(middle, right, roots, count);
    return count;
}

// Private: coefficients whose twelfth powers float32 holds: all that come of r <= 100 R do.
bool torus_isTame(TorusReducedQuartic f) {
    return abs(f.alpha) <= 1.0e5 && abs(f.cz) <= 1.0e7 && abs(f.beta) <= 1.0e10;
}

// Private: the real roots by torus_resolventRoot.
int torus_rootsByParts(TorusReducedQuartic quartic, float part, float k, out float roots[4]) {
    for (int i = 0; i < 4; ++i) {
        roots[i] = 0.0;
    }
    if (!torus_isTame(quartic)) {
        return 0;
    }
    return torus_pairs(quartic, torus_resolventRoot(torus_resolvent(quartic), part, k), roots);
}

// The real roots of the reduced quartic, first version: zeta = cbrt((gamma + sqrt(epsilon)) / 2) (math.md, eq. 18).
//
// quartic    |alpha| <= 1e5, |c z| <= 1e7, |beta| <= 1e10; otherwise, and for NaN, there are no roots
// roots      ascending, multiple ones as often as they count; entries past the last one are 0
// returns    their number: 0, 2 or 4
int torusReducedRoots(TorusReducedQuartic quartic, out float roots[4]) {
    return torus_rootsByParts(quartic, 0.5, 1.0, roots);
}

// The same, second version: zeta = cbrt(gamma + sqrt(epsilon)), the 2 moved into the solutions (math.md, eq. 19).
//
// quartic, roots, returns   as for torusReducedRoots
int torusReducedRootsUnhalved(TorusReducedQuartic quartic, out float roots[4]) {
    return torus_rootsByParts(quartic, 1.0, torus_cubeRoot(2.0), roots);
}

// Where the whole line of a ray meets the torus: every real root of its quartic, both sheets of a spindle.
//
// t          of the ray as given, ascending; entries past the last one are 0
// returns    their number: 0, 2 or 4; 0 where torusReduceRay is false
int torusClosedFormRoots(Torus torus, vec3 origin, vec3 direction, out float t[4]) {
    for (int i = 0; i < 4; ++i) {
        t[i] = 0.0;
    }
    TorusReducedRay ray;
    if (!torusReduceRay(torus, origin, direction, ray)) {
        return 0;
    }
    float roots[4];
    int count = torusReducedRoots(torusAxialQuartic(ray), roots);
    for (int i = 0; i < count; ++i) {
        TORUS_PRECISE float at = ray.shift + ray.scale * roots[i];
        t[i] = clamp(at, -TORUS_FLOAT_MAX, TORUS_FLOAT_MAX);
    }
    return count;
}

#endif
