// SPDX-License-Identifier: MIT
//
// raytorus: where a ray meets a torus.
//
// The torus has its centre at the origin and its axis along +z. majorRadius (R) is the radius of the ring, the circle
// in the middle of the tube; minorRadius (r) is the radius of the tube. Any other placement is the caller's: transform
// the ray into the torus' frame (ray tracing shaders are handed gl_ObjectRayOriginEXT and gl_ObjectRayDirectionEXT).
//
//   - The ray's points are origin + t * direction. The direction needs no unit length; t counts in its length.
//   - Hits have tMin <= t <= tMax; one exactly at an end may go either way. tMax may be infinite.
//   - r < R is a ring, r = R a horn, r > R a spindle: of that the outer sheet only, the boundary of the solid
//     {(rho - R)^2 + z^2 <= r^2} with rho^2 = x^2 + y^2. R = 0 is a sphere.
//   - A ray that touches the surface without crossing it has both hits there or neither. So a ray that starts outside
//     and ends outside has 0, 2 or 4 hits, one that starts inside has 1 or 3.
//   - A hit is entering where dot(torusNormal(torus, hit.position), direction) < 0.
//   - No hit: the function says so, t = tMax, position = (0, 0, 0). Every output is always written.
//   - r <= 0, R < 0, a NaN or infinity in torus, origin or direction, a zero direction, tMin > tMax: no hit.
//     A NaN in tMin or tMax: no hit, and t = 0. Nothing non-finite comes out, but a tMax that went in.
//   - Sizes: R + r from 1e-18 to 1e18, directions from 1e-18 to 1e18 long; beyond, there is no hit. Tubes may be as thin as
//     r/R = 1e-6; of one of 1e-7 a verdict in 100 000 is wrong.
//   - Loops are bounded by a constant. Hits are decided by + - * / sqrt and comparisons alone: no built-in of loose
//     precision. Every step is `precise`, so drivers that round these operations correctly give the same bits.
//
// `#define TORUS_FAST` before the include: the same functions in plain float32, with half the code. Right verdicts, counts
// and order where no tangent is nearer than 1e-3 r and r/R is 1e-3 to 1.5, but for a horn's tip; positions to 4e-6 (R + r)
// for 99 of 100 hits; a start or an end nearer to the surface than 1.5e-6 (R + r) counts as one on it: a hit there
// may go either way. The bits may differ between drivers.
//
// Where the device's fma() is known to round once, as that of most GPUs does and that of CPU drivers does not
// (`raytorus doctor` asks), `#define TORUS_FUSED_FMA` before the include: the same bits with an eighth less code. Where it
// rounds twice, that loses what this library is for.
//
// Needs GLSL 4.60 (or 4.50) with #extension GL_GOOGLE_include_directive, or a pasted copy of this folder's files.
#ifndef TORUS_GLSL
#define TORUS_GLSL

#define TORUS_VERSION_MAJOR 0
#define TORUS_VERSION_MINOR 1
#define TORUS_VERSION_PATCH 0
#define TORUS_VERSION (TORUS_VERSION_MAJOR * 10000 + TORUS_VERSION_MINOR * 100 + TORUS_VERSION_PATCH)

// A shader that needs at least version 1.2.3 says `#define TORUS_VERSION_REQUIRED 10203` before the include.
#ifdef TORUS_VERSION_REQUIRED
#if TORUS_VERSION_REQUIRED > TORUS_VERSION
#error the library is older than TORUS_VERSION_REQUIRED
#endif
#endif

#include "language.glsl"

struct Torus {
    float majorRadius;
    float minorRadius;
};

struct TorusHit {
    float t;
    vec3 position;  // on the surface, in the torus' frame; more exact than origin + t * direction
};

#include "circle.glsl"
#ifdef TORUS_FAST
#include "refine_fast.glsl"
#else
#include "refine.glsl"
#endif

// Private: what is written where there is no hit. Comparisons with NaN are false, and so give 0.
TorusHit torus_miss(float tMax) {
    return TorusHit(tMax >= -TORUS_FLOAT_MAX ? tMax : 0.0, vec3(0.0, 0.0, 0.0));
}

// Private: the hit at a crossing of the line.
TorusHit torus_hitAt(const torus_Line line, torus_Crossing crossing, float tMin, float tMax) {
    TORUS_PRECISE vec3 position = crossing.position * line.unit;
    TORUS_PRECISE float sum = line.baseShift + crossing.shift;
    TORUS_PRECISE float t =
        (sum + (torus_twoSumError(line.baseShift, crossing.shift, sum) + crossing.rest)) * line.tPerU;
    // Not min and max: of two zeros of different sign they may return either.
    t = t >= tMin ? t : tMin;
    t = t <= tMax ? t : tMax;
    return TorusHit(t, position);
}

// The nearest hit.
//
// torus      radii, in the caller's unit of length
// origin     of the ray, in the torus' frame. From up to 10^8 (R + r) away the position of the hit is exact to the
//            torus' size
// tMin       start of the ray, in lengths of `direction`
// direction  of the ray, of any length but zero
// tMax       end of the ray; may be infinite
// hit        the hit with the smallest t; t = tMax and position = 0 if there is none
// returns    whether there is one
bool torusIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    TorusHit nearest = torus_miss(tMax);
    bool hits = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets) {
        if (torus_clip(line, tMin, tMax)) {
            torus_Quartic quartic = torus_quartic(line);
            torus_March march = torus_startMarch(line, quartic);
            torus_Crossing crossing = torus_nextCrossing(line, quartic, march);
            hits = crossing.found && torus_isWithin(line, crossing);
            if (hits) {
                nearest = torus_hitAt(line, crossing, tMin, tMax);
            }
        }
    }
    hit = nearest;
    return hits;
}

// Is there any hit? For shadow rays: cheaper than torusIntersect, because most crossings need no refinement.
//
// torus, origin, tMin, direction, tMax   as for torusIntersect
bool torusOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    bool hits = false;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets) {
        if (torus_clip(line, tMin, tMax)) {
            torus_Quartic quartic = torus_quartic(line);
            torus_March march = torus_startMarch(line, quartic);
            hits = torus_crosses(line, quartic, march);
        }
    }
    return hits;
}

// Every hit, in ascending t.
//
// torus, origin, tMin, direction, tMax   as for torusIntersect
// hits       the hits; entries past the last one hold t = tMax and position = 0
// returns    their number, 0 to 4
int torusIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    int count = 0;
    torus_Line line = torus_reduce(torus.majorRadius, torus.minorRadius, origin, tMin, direction, tMax);
    if (line.meets) {
        if (torus_clip(line, tMin, tMax)) {
            torus_Quartic quartic = torus_quartic(line);
            torus_March march = torus_startMarch(line, quartic);
            float from = tMin;  // where a line touches, rounding must not swap the pair
            bool busy = true;
            for (int i = 0; i < TORUS_PASSES && busy; ++i) {
                torus_search(quartic, line.upper, TORUS_PASS_STEPS, march);
                if (march.refines) {
                    torus_Crossing crossing = torus_refine(line, march);
                    if (crossing.found && torus_isWithin(line, crossing)) {
                        TorusHit hit = torus_hitAt(line, crossing, from, tMax);
                        // Some drivers handle an index that they know much better.
                        for (int k = 0; k < 4; ++k) {
                            if (k == count) {
                                hits[k] = hit;
                            }
                        }
                        from = hit.t;
                        ++count;
                    }
                }
                busy = march.searching && count < 4;
            }
        }
    }
    return count;
}

// The unit normal at a point of the surface: away from the middle of the tube, never turned towards the viewer.
//
// position   on the surface or near it. On the tube's centre circle and on the axis of a spindle, where no direction
//            is distinguished, some unit vector.
// returns    unit length, to 2^-22
vec3 torusNormal(Torus torus, vec3 position) {
    TORUS_PRECISE float rho = sqrt(position.x * position.x + position.y * position.y);
    TORUS_PRECISE float q = rho - torus.majorRadius;
    TORUS_PRECISE float tube = sqrt(q * q + position.z * position.z);
    if (!(tube > 0.0)) {
        return vec3(0.0, 0.0, 1.0);
    }
    TORUS_PRECISE float radial = q / tube;
    TORUS_PRECISE float perRho = rho > 0.0 ? radial / rho : 0.0;
    TORUS_PRECISE float x = rho > 0.0 ? position.x * perRho : radial;
    TORUS_PRECISE float y = position.y * perRho;
    TORUS_PRECISE float z = position.z / tube;
    return vec3(x, y, z);
}

// The parameters of a point of the surface, in turns: u round the axis from +x towards +y, v round the tube from the
// outer equator towards +z.
//
// position   on the surface or near it
// returns    (u, v), each in [0, 1); right to 1e-7 of a turn, v in a thin tube to 1e-7 (R + r) / r
vec2 torusUv(Torus torus, vec3 position) {
    TORUS_PRECISE float rho = sqrt(position.x * position.x + position.y * position.y);
    TORUS_PRECISE float q = rho - torus.majorRadius;
    return vec2(torus_turn(position.y, position.x), torus_turn(position.z, q));
}

// The point with the parameters uv:
//     ((R + r cos 2 pi v) cos 2 pi u, (R + r cos 2 pi v) sin 2 pi u, r sin 2 pi v)
//
// uv         in turns; any finite value, whole turns are dropped
vec3 torusPosition(Torus torus, vec2 uv) {
    vec2 ring = torus_circle(uv.x);
    vec2 tube = torus_circle(uv.y);
    TORUS_PRECISE float rho = torus.majorRadius + torus.minorRadius * tube.x;
    TORUS_PRECISE float x = rho * ring.x;
    TORUS_PRECISE float y = rho * ring.y;
    TORUS_PRECISE float z = torus.minorRadius * tube.y;
    return vec3(x, y, z);
}

// The derivatives of torusPosition by u and v at a point of the surface. dPdu x dPdv points outwards where the
// surface is outside the axis.
//
// position   on the surface or near it
// dPdu       length 2 pi rho: a whole turn round the axis
// dPdv       length 2 pi r: a whole turn round the tube
void torusTangents(Torus torus, vec3 position, out vec3 dPdu, out vec3 dPdv) {
    const float twoPi = 6.28318531;
    TORUS_PRECISE float rho = sqrt(position.x * position.x + position.y * position.y);
    TORUS_PRECISE float cosU = rho > 0.0 ? position.x / rho : 1.0;
    TORUS_PRECISE float sinU = rho > 0.0 ? position.y / rho : 0.0;
    TORUS_PRECISE float rise = twoPi * position.z;
    TORUS_PRECISE float q = twoPi * (rho - torus.majorRadius);
    TORUS_PRECISE vec3 alongU = vec3(-twoPi * position.y, twoPi * position.x, 0.0);
    TORUS_PRECISE vec3 alongV = vec3(-rise * cosU, -rise * sinU, q);
    dPdu = alongU;
    dPdv = alongV;
}

// The distance to the surface, negative inside: exact, also inside a spindle, whose dimples end in a point.
//
// point      anywhere
float torusDistance(Torus torus, vec3 point) {
    TORUS_PRECISE float rho = sqrt(point.x * point.x + point.y * point.y);
    TORUS_PRECISE float q = rho - torus.majorRadius;
    TORUS_PRECISE float tube = sqrt(q * q + point.z * point.z);
    TORUS_PRECISE float distance = tube - torus.minorRadius;
    // Inside a spindle the tube's radius can end beyond the axis, off the outer sheet: the dimple's tip is nearest.
    TORUS_PRECISE float landing = torus.majorRadius * tube + q * torus.minorRadius;
    if (landing < 0.0) {
        TORUS_PRECISE float tip = sqrt(
            max((torus.minorRadius - torus.majorRadius) * (torus.minorRadius + torus.majorRadius), 0.0));
        TORUS_PRECISE float rise = abs(point.z) - tip;
        TORUS_PRECISE float toTip = sqrt(rho * rho + rise * rise);
        distance = -toTip;
    }
    return distance;
}

// The implicit function (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2): zero on the surface (and on a spindle's
// inner sheet), of the fourth power of a length. Evaluated as a product, which keeps its sign near the surface.
//
// point      anywhere
float torusImplicit(Torus torus, vec3 point) {
    TORUS_PRECISE float rho = sqrt(point.x * point.x + point.y * point.y);
    TORUS_PRECISE float q = rho - torus.majorRadius;
    TORUS_PRECISE float p = rho + torus.majorRadius;
    TORUS_PRECISE float z2 = point.z * point.z;
    TORUS_PRECISE float outerSheet = (q - torus.minorRadius) * (q + torus.minorRadius) + z2;
    TORUS_PRECISE float innerSheet = (p - torus.minorRadius) * (p + torus.minorRadius) + z2;
    TORUS_PRECISE float value = outerSheet * innerSheet;
    return value;
}

// What torusSelfCheck finds, of a compiler and a device together. The exact tier needs the first three.
#define TORUS_CHECK_SUMS 1        // the rounding of a sum is found again: nothing is reassociated
#define TORUS_CHECK_PRODUCTS 2    // ... and that of a product
#define TORUS_CHECK_HIGHP 4       // a float has 24 bits, and reaches from 1e-30 to 1e30
#define TORUS_CHECK_FUSED_FMA 8   // fma() rounds once: TORUS_FUSED_FMA gives the same bits. 0 where there is no fma()
#define TORUS_CHECK_DENORMALS 16  // numbers below 2^-126 are kept

// Whether the arithmetic here is what the library rests on. For those who take it to another language or device.
//
// one        1, from where no compiler knows it: a uniform or a buffer
// returns    the sum of those TORUS_CHECK_... that hold
int torusSelfCheck(float one) {
    // By bits, so that algebra knows nothing of them: 2^-25, 1 + 2^-12 and 1 + 2^-23.
    float little = uintBitsToFloat(floatBitsToUint(one) - 0x0c800000u);
    float factor = uintBitsToFloat(floatBitsToUint(one) + 0x00000800u);
    float next = uintBitsToFloat(floatBitsToUint(one) + 1u);
    TORUS_PRECISE float sum = one + little;
    TORUS_PRECISE float sumError = torus_twoSumError(one, little, sum);
    TORUS_PRECISE float square = factor * factor;
    TORUS_PRECISE float squareError = torus_twoProductError(factor, factor, square);
    TORUS_PRECISE float step = next - one;
    TORUS_PRECISE float large = one * 1.0e30;
    TORUS_PRECISE float tiny = one * 1.0e-30;
    TORUS_PRECISE float least = one * 1.17549435e-38;  // 2^-126
    TORUS_PRECISE float denormal = least * 0.5;
    int holds = 0;
    if (sum == 1.0 && sumError == 2.98023224e-8) {
        holds += TORUS_CHECK_SUMS;
    }
    if (squareError == 5.96046448e-8) {  // 2^-24
        holds += TORUS_CHECK_PRODUCTS;
    }
    if (step == 1.1920929e-7 && large > 0.9e30 && large < 1.1e30 && tiny > 0.9e-30 && tiny < 1.1e-30) {
        holds += TORUS_CHECK_HIGHP;
    }
#ifndef TORUS_NO_FMA
    TORUS_PRECISE float fused = fma(factor, factor, -square);
    if (fused == 5.96046448e-8) {
        holds += TORUS_CHECK_FUSED_FMA;
    }
#endif
    if (floatBitsToUint(denormal) == 0x00400000u) {
        holds += TORUS_CHECK_DENORMALS;
    }
    return holds;
}

#endif
