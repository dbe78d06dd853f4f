// SPDX-License-Identifier: MIT
// Private: a ray reduced to what the march needs. Radii, origin and direction are scaled by powers of two to the size of
// the torus, and the parameter counts from the foot, the point closest to the centre, so that no number of the march is
// larger than the torus. Then the line is clipped to where the torus can be.
#ifndef TORUS_RAY_GLSL
#define TORUS_RAY_GLSL

#include "double_float.glsl"

// The line's points are base + baseLow + (shift + u) * direction, with the foot at u = 0. The unit of length is the power
// of two at or below R + r, so R + r is in [1, 2).
struct torus_Line {
    bool meets;          // false: bad input, or the line misses the bounding sphere
    float majorRadius;   // R, in units
    float minorRadius;   // r, in units
    vec3 base;           // the origin, in units; or, of a far origin, a point near the foot ...
    vec3 baseLow;        // ... and what its rounding took away
    float baseShift;     // from the origin to the base, in lengths of `direction`
    float shift;         // from the base to the foot, in lengths of `direction`
    vec3 direction;      // as given, but for a power of two
    float length2;       // its squared length
    float invLength2;
    vec3 foot;           // in units
    float foot2;         // its squared distance from the centre
    float chord2;        // the square of the bounding sphere's half chord
    float farthest;      // the largest coordinate of the base: the foot is known to some 2^-23 of it
    float lower;         // the interval of u that torus_clip leaves
    float upper;
    bool fromStart;      // it begins at the ray's start, not where the line enters the sphere or the planes
    float endShift;      // from the base to the ray's end
    float tPerU;         // t = (baseShift + shift + u) * tPerU
    float uPerT;
    float unit;          // the length of one unit
};

// The bit patterns of the least power of two for R + r, 2^-60, and for the longest component of a direction, 2^-63, and
// how many bit patterns lie between these and the largest, 2^60 and 2^64. A ray beyond is none: the reciprocals of the
// units, or their quotient, would leave float32.
#define TORUS_LEAST_SIZE 0x21800000u
#define TORUS_SIZE_RANGE 0x3c000000u
#define TORUS_LEAST_LENGTH 0x20000000u
#define TORUS_LENGTH_RANGE 0x3f800000u

// An origin with a coordinate beyond this, in units, is far. Two moves to the foot bring any origin nearer whose
// coordinates float32 can tell from the torus.
#define TORUS_FAR 8.0
#define TORUS_FAR_MOVES 2

// Padding of the bounding sphere, relative to its squared radius. A ray in the plane z = 0 meets sphere and torus in the
// same point: rounding, some 2^-20 where the origin is 8 units away, must not clip the torus' crossing.
#define TORUS_SPHERE_PADDING 1.00002

// Padding of the planes, in units: more than rounding and than how far the march goes on from a crossing, or it would be
// past the planes in a tube as thin as that, with the way out still to come.
#define TORUS_PLANE_PADDING 6.0e-6

// Padding of the ray's end, in lengths of the direction: more than the march can be off by. Whether a crossing is before the
// end is decided by its exact place.
#define TORUS_END_PADDING 1.0e-5

// The largest coordinate.
float torus_longest(vec3 v) {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

#ifdef TORUS_FAST
// Moves the origin towards the foot, for near and far origins alike: by a parameter of 12 bits, whose products with the
// direction's halves are exact. Returns the parameter.
float torus_moveToFoot(inout vec3 base, out vec3 baseLow, vec3 direction, float invLength2) {
    TORUS_PRECISE float move =
        -(base.x * direction.x + base.y * direction.y + base.z * direction.z) * invLength2;
    float gone = torus_upperHalf(move);
    vec3 high = vec3(torus_upperHalf(direction.x), torus_upperHalf(direction.y), torus_upperHalf(direction.z));
    TORUS_ROUNDED vec3 moved = (base + gone * high) + gone * (direction - high);
    base = moved;
    baseLow = vec3(0.0, 0.0, 0.0);
    return gone;
}
#else
// Moves a far origin to the foot. Any parameter near the foot's will do, as the point that belongs to it is exact. Returns
// the parameter.
float torus_moveToFoot(inout vec3 base, out vec3 baseLow, vec3 direction, float invLength2) {
    TORUS_PRECISE float shift = 0.0;
    baseLow = vec3(0.0, 0.0, 0.0);
    bool isFar = torus_longest(base) > TORUS_FAR;
    for (int i = 0; i < TORUS_FAR_MOVES && isFar; ++i) {
        TORUS_PRECISE float move =
            -(base.x * direction.x + base.y * direction.y + base.z * direction.z) * invLength2;
        // What the sum of the moves loses is not gone, either.
        TORUS_PRECISE float moved = shift + move;
        TORUS_PRECISE float gone = moved - shift;
        vec3 low;
        base = torus_advance3(base, baseLow, gone, 0.0, direction, low);
        baseLow = low;
        shift = moved;
        isFar = torus_longest(base) > TORUS_FAR;
    }
    return shift;
}
#endif

// Reduces a ray. `tMin` and `tMax` only have to be valid.
torus_Line torus_reduce(float majorRadius, float minorRadius, vec3 origin, float tMin, vec3 direction, float tMax) {
    // Bit patterns of positive floats are in the order of the floats, with infinity and NaN behind all. What is made of an
    // invalid ray may be anything: `meets` is false then.
    uint size = floatBitsToUint(majorRadius + minorRadius);
    uint x = floatBitsToUint(direction.x) & 0x7fffffffu;
    uint y = floatBitsToUint(direction.y) & 0x7fffffffu;
    uint z = floatBitsToUint(direction.z) & 0x7fffffffu;
    uint longest = max(max(x, y), z);
    bool valid = minorRadius > 0.0 && majorRadius >= 0.0 && tMin <= tMax &&
                 size - TORUS_LEAST_SIZE < TORUS_SIZE_RANGE && longest - TORUS_LEAST_LENGTH < TORUS_LENGTH_RANGE;
    float unit = uintBitsToFloat(size & 0x7f800000u);
    float directionUnit = uintBitsToFloat(longest & 0x7f800000u);
    TORUS_PRECISE float invUnit = torus_invPowerOfTwo(unit);
    TORUS_PRECISE float invDirectionUnit = torus_invPowerOfTwo(directionUnit);
    TORUS_PRECISE vec3 base = origin * invUnit;
    TORUS_PRECISE vec3 d = direction * invDirectionUnit;
    TORUS_PRECISE float R = majorRadius * invUnit;
    TORUS_PRECISE float r = minorRadius * invUnit;
    // Both are powers of two: no bit of t is lost on the way.
    TORUS_PRECISE float tPerU = unit * invDirectionUnit;
    TORUS_PRECISE float uPerT = directionUnit * invUnit;
    // The direction is not normalised: that would turn the ray by an ulp, which far away is more than the torus' rounding.
    TORUS_PRECISE float dd = d.x * d.x + d.y * d.y + d.z * d.z;
    TORUS_PRECISE float invDd = 1.0 / dd;

    vec3 baseLow;
    float baseShift = torus_moveToFoot(base, baseLow, d, invDd);
    float farthest = torus_longest(base);

    // The foot, and the bounding sphere.
    TORUS_PRECISE float shift = -(base.x * d.x + base.y * d.y + base.z * d.z) * invDd;
    TORUS_PRECISE vec3 foot = base + shift * d;
    TORUS_PRECISE float foot2 = foot.x * foot.x + foot.y * foot.y + foot.z * foot.z;
    TORUS_PRECISE float outer = R + r;
    TORUS_PRECISE float chord2 = TORUS_SPHERE_PADDING * (outer * outer) - foot2;
    return torus_Line(valid && chord2 > 0.0, R, r, base, baseLow, baseShift, shift, d, dd, invDd, foot, foot2, chord2,
                      farthest, 0.0, 0.0, false, 0.0, tPerU, uPerT, unit);
}

// Clips a line that meets the bounding sphere to where it can cross the torus: to the sphere, to what is between the
// planes z = -r and z = r, and to the ray. Returns whether anything is left.
bool torus_clip(inout torus_Line line, float tMin, float tMax) {
    TORUS_PRECISE float halfChord = sqrt(line.chord2 * line.invLength2);
    TORUS_PRECISE float invRise = 1.0 / (abs(line.direction.z) + 1.0e-30);
    TORUS_PRECISE float middle = line.foot.z * (line.direction.z < 0.0 ? invRise : -invRise);
    TORUS_PRECISE float halfSlab = (line.minorRadius + TORUS_PLANE_PADDING) * invRise;
    TORUS_PRECISE float enter = max(middle - halfSlab, -halfChord);
    TORUS_PRECISE float leave = min(middle + halfSlab, halfChord);
    // Infinite ends are legal; what lies beyond the largest t is beyond these.
    TORUS_PRECISE float begin = (max(tMin, -TORUS_FLOAT_MAX) * line.uPerT - line.baseShift) - line.shift;
    TORUS_PRECISE float endShift = min(tMax, TORUS_FLOAT_MAX) * line.uPerT - line.baseShift;
    TORUS_PRECISE float end = (endShift - line.shift) + TORUS_END_PADDING;
    TORUS_PRECISE float lower = max(begin, enter);
    TORUS_PRECISE float upper = min(end, leave);
    line.lower = lower;
    line.upper = upper;
    line.endShift = endShift;
    line.fromStart = begin > enter;
    return lower <= upper;
}

#endif
