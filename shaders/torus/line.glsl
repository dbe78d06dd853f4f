// SPDX-License-Identifier: MIT
// Private: a ray reduced to what the solver needs. Scaled by powers of two to the size of the torus, its parameter
// counted from the point closest to the centre, so that nothing the solver sees is larger than the torus.
#ifndef TORUS_LINE_GLSL
#define TORUS_LINE_GLSL

#include "arithmetic.glsl"

// A statement for each step of each loop, for counting them: empty unless defined before.
#ifndef TORUS_ON_STEP
#define TORUS_ON_STEP
#endif

// The points base + baseLow + (shift + shiftRest + u) * direction. One unit is the power of two at or below R + r, so
// R + r is in [1, 2).
struct torus_Line {
    bool meets;            // false: no part of the ray is in the bounding sphere
    float majorRadius;     // R in units
    float minorRadius;     // r in units
    vec3 foot;             // the point closest to the centre, u = 0, to some 10^-6; torus_refine makes it better
    float foot2;           // its squared distance from the centre
    vec3 base;             // the origin, in units; or a point near the foot ...
    vec3 baseLow;          // ... and what its rounding took away
    float baseShift;       // from the origin to the base, in lengths of `direction`
    float shift;           // from the base to the foot ...
    float shiftRest;       // ... and what is left of that, once it is refined
    vec3 direction;
    float length2;         // its squared length
    float perLength2;
    float outer2;          // (R + r)^2
    float enter;           // where the line can be in the torus: in its bounding sphere and, once cut, between
    float leave;           //   z = -r and z = r. Outside the torus at both ends
    float lower;           // the searched interval of u: what [tMin, tMax] leaves of that
    float upper;
    float halfChord;       // the bounding sphere spans [-halfChord, halfChord]
    float tPerU;           // t = (baseShift + shift + u) * tPerU
    float uPerT;
    float unit;            // length of one unit
};

// The bit patterns of the least and the largest powers of two for R + r and for the longest component of a direction, 2^-60 to
// 2^59 and 2^-63 to 2^63. A ray beyond is none: the reciprocals of the units, or their quotient, would leave float32.
#define TORUS_LEAST_SIZE 0x21800000u
#define TORUS_LARGEST_SIZE 0x5d000000u
#define TORUS_LEAST_LENGTH 0x20000000u
#define TORUS_LARGEST_LENGTH 0x5f000000u

// Room around the bounding sphere, relative to its squared radius. A ray in the plane z = 0 meets sphere and torus in
// the same point: rounding (some 2^-20 where the origin is 8 units away) must not put the torus' root outside the
// searched interval.
#define TORUS_SPHERE_ROOM 1.00002

// Room around the planes and the hole that cut a line, in units: some ten roundings.
#define TORUS_ROOM 2.0e-6

// An origin with a coordinate beyond this, in units, is far away.
#define TORUS_AFAR 8.0
// Of such an origin o the moment m = o x d is off by up to e = sqrt(3) 2^-23 |o| |d|, and |o|^2 is at most three times the
// square of its largest component. (|m| + e)^2 <= 17/16 |m|^2 + 17 e^2: what is beyond that passes the bounding sphere by.
#define TORUS_AFAR_ROOM 1.0626
#define TORUS_AFAR_ROUNDING 2.2e-12

// A ring whose hole is as small as this leaves has no tip: nearer to a horn, whose sheets meet, the exact solver does all.
#define TORUS_RING 0.9375

// base + baseLow + (factor + factorLow) * direction, each component as in torus_advance.
vec3 torus_advance3(vec3 base, vec3 baseLow, float factor, float factorLow, vec3 direction, out vec3 low) {
    TORUS_PRECISE vec3 little = baseLow + factorLow * direction;
    float lowX;
    float lowY;
    float lowZ;
    float x = torus_advance(base.x, factor, direction.x, little.x, lowX);
    float y = torus_advance(base.y, factor, direction.y, little.y, lowY);
    float z = torus_advance(base.z, factor, direction.z, little.z, lowZ);
    low = vec3(lowX, lowY, lowZ);
    return vec3(x, y, z);
}

vec3 torus_cross(vec3 a, vec3 b) {
    TORUS_PRECISE float x = a.y * b.z - a.z * b.y;
    TORUS_PRECISE float y = a.z * b.x - a.x * b.z;
    TORUS_PRECISE float z = a.x * b.y - a.y * b.x;
    return vec3(x, y, z);
}

// A ray in units, and whether it is worth reducing.
struct torus_Ray {
    bool meets;           // false: bad input, or the ray passes the bounding sphere by
    float majorRadius;
    float minorRadius;
    vec3 base;            // base, baseLow and baseShift as of torus_Line
    vec3 baseLow;
    float baseShift;
    vec3 direction;       // as given, scaled by a power of two: its longest component is in [1, 2)
    float length2;        // its squared length
    float perLength2;
    float shift;          // from the base to the point closest to the centre, in lengths of `direction`
    vec3 moment;          // base x direction
    float moment2;        // its squared length
    float outer2;         // (R + r)^2
    float chord2;         // the square of the bounding sphere's half chord, times length2^2
    float tPerU;
    float uPerT;
    float unit;
};

// A ray in units. What is known of it is computed for every ray, and no branch of this file returns early: compilers
// carry each value that a branch may or may not have set through memory, from there to its last use. For the same reason
// a far origin is moved first of all, when there is least to carry.
torus_Ray torus_scale(float majorRadius, float minorRadius, vec3 origin, float tMin, vec3 direction, float tMax) {
    // Bit patterns of positive floats are in the order of the floats, with infinity and NaN behind all. What is made of an
    // invalid ray may be anything: `meets` is false then, and no branch is taken in which it would be used.
    uint size = floatBitsToUint(majorRadius + minorRadius);
    uint x = floatBitsToUint(direction.x) & 0x7fffffffu;
    uint y = floatBitsToUint(direction.y) & 0x7fffffffu;
    uint z = floatBitsToUint(direction.z) & 0x7fffffffu;
    uint longest = max(max(x, y), z);
    bool valid = minorRadius > 0.0 && majorRadius >= 0.0 && size >= TORUS_LEAST_SIZE &&
                 size < TORUS_LARGEST_SIZE + 0x00800000u && longest >= TORUS_LEAST_LENGTH &&
                 longest < TORUS_LARGEST_LENGTH + 0x00800000u && tMin <= tMax;
    float unit = uintBitsToFloat(size & 0x7f800000u);
    float directionUnit = uintBitsToFloat(longest & 0x7f800000u);
    TORUS_PRECISE float perUnit = torus_powerOfTwoReciprocal(unit);
    TORUS_PRECISE float perDirectionUnit = torus_powerOfTwoReciprocal(directionUnit);
    TORUS_PRECISE vec3 o = origin * perUnit;
    TORUS_PRECISE vec3 d = direction * perDirectionUnit;
    TORUS_PRECISE float R = majorRadius * perUnit;
    TORUS_PRECISE float r = minorRadius * perUnit;
    // Both are powers of two: no bit of t is lost on the way.
    TORUS_PRECISE float tPerU = unit * perDirectionUnit;
    TORUS_PRECISE float uPerT = directionUnit * perUnit;
    // The direction stays as given, because normalising it would turn the ray by an ulp, which far away is more than
    // the torus' own rounding.
    TORUS_PRECISE float dd = d.x * d.x + d.y * d.y + d.z * d.z;
    TORUS_PRECISE float perDd = 1.0 / dd;
    // From afar, move to the foot of the perpendicular, unless the ray clearly passes the torus by. Any parameter near the
    // foot's does as long as the point that belongs to it is known exactly. So it has to be at the tips of horns and
    // spindles, too.
    TORUS_PRECISE float ring = TORUS_RING * R;
    TORUS_PRECISE float farthest = max(max(abs(o.x), abs(o.y)), abs(o.z));
    bool delicate = farthest > TORUS_AFAR || r > ring;
    vec3 base = o;
    vec3 baseLow = vec3(0.0, 0.0, 0.0);
    TORUS_PRECISE float baseShift = 0.0;
    if (delicate) {
        // The moment of the origin, not yet of the base. It and the sphere are found in here although they are again below:
        // what both share would be carried past the branch, and cost nearby rays more.
        TORUS_PRECISE vec3 away = torus_cross(o, d);
        TORUS_PRECISE float away2 = away.x * away.x + away.y * away.y + away.z * away.z;
        TORUS_PRECISE float sphere2 = TORUS_AFAR_ROOM * ((R + r) * (R + r)) + TORUS_AFAR_ROUNDING * (farthest * farthest);
        TORUS_PRECISE float passing2 = sphere2 * dd;
        // Beyond all numbers it is not known.
        bool passes = away2 > passing2;
        if (!passes) {
            TORUS_PRECISE float toFoot = -(o.x * d.x + o.y * d.y + o.z * d.z) * perDd;
            base = torus_advance3(o, vec3(0.0, 0.0, 0.0), toFoot, 0.0, d, baseLow);
            baseShift = toFoot;
        }
    }
    TORUS_PRECISE float shift = -(base.x * d.x + base.y * d.y + base.z * d.z) * perDd;
    // Most rays that miss pass the bounding sphere by. Their distance from the centre by the moment, which needs no
    // division: nothing waits for that but what is in the branch.
    TORUS_PRECISE vec3 moment = torus_cross(base, d);
    TORUS_PRECISE float moment2 = moment.x * moment.x + moment.y * moment.y + moment.z * moment.z;
    TORUS_PRECISE float outer2 = (R + r) * (R + r);
    TORUS_PRECISE float chord2 = TORUS_SPHERE_ROOM * outer2 * dd - moment2;
    bool meets = valid && chord2 > 0.0;
    return torus_Ray(meets, R, r, base, baseLow, baseShift, d, dd, perDd, shift, moment, moment2, outer2, chord2, tPerU,
                     uPerT, unit);
}

// Reduces a ray that meets the bounding sphere, as well as a search for clear crossings needs it.
torus_Line torus_reduce(torus_Ray ray, float tMin, float tMax) {
    TORUS_PRECISE float perDd = ray.perLength2;
    // o - d (o . d) / dd = d x (o x d) / dd (Lagrange), of which the moment is there already.
    TORUS_PRECISE vec3 foot = torus_cross(ray.direction, ray.moment) * perDd;
    TORUS_PRECISE float foot2 = ray.moment2 * perDd;
    TORUS_PRECISE float halfChord = sqrt(ray.chord2) * perDd;
    // Infinite ends are legal; what lies beyond the largest t is beyond these.
    TORUS_PRECISE float begins = (max(tMin, -TORUS_FLOAT_MAX) * ray.uPerT - ray.baseShift) - ray.shift;
    TORUS_PRECISE float ends = (min(tMax, TORUS_FLOAT_MAX) * ray.uPerT - ray.baseShift) - ray.shift;
    TORUS_PRECISE float lower = max(begins, -halfChord);
    TORUS_PRECISE float upper = min(ends, halfChord);
    return torus_Line(ray.meets && lower <= upper, ray.majorRadius, ray.minorRadius, foot, foot2, ray.base, ray.baseLow,
                      ray.baseShift, ray.shift, 0.0, ray.direction, ray.length2, perDd, ray.outer2, -halfChord, halfChord,
                      lower, upper, halfChord, ray.tPerU, ray.uPerT, ray.unit);
}

// Cuts the searched interval by the planes z = -r and z = r. Returns whether anything is left of it that is not in the
// hole.
bool torus_cut(inout torus_Line line) {
    // Where the line crosses the plane z = 0, and how far it is from there to the others.
    TORUS_PRECISE float rise = line.direction.z;
    TORUS_PRECISE float perRise = 1.0 / (abs(rise) + 1.0e-30);
    TORUS_PRECISE float middle = line.foot.z * (rise < 0.0 ? perRise : -perRise);
    TORUS_PRECISE float halfSlab = (line.minorRadius + TORUS_ROOM) * perRise;
    TORUS_PRECISE float slabEnter = middle - halfSlab;
    TORUS_PRECISE float slabLeave = middle + halfSlab;
    TORUS_PRECISE float enter = max(slabEnter, line.enter);
    TORUS_PRECISE float leave = min(slabLeave, line.leave);
    TORUS_PRECISE float lower = max(line.lower, slabEnter);
    TORUS_PRECISE float upper = min(line.upper, slabLeave);
    line.enter = enter;
    line.leave = leave;
    line.lower = lower;
    line.upper = upper;
    // The distance from the centre is convex: where both ends are nearer to it than R - r, all between is in the hole.
    TORUS_PRECISE float farthest2 = max(lower * lower, upper * upper) * line.length2 + line.foot2;
    TORUS_PRECISE float hole = max(line.majorRadius - line.minorRadius - TORUS_ROOM, 0.0);
    TORUS_PRECISE float hole2 = hole * hole;
    return lower <= upper && farthest2 >= hole2;
}

// Makes the foot as right as the exact solver needs it, to which a line that is not perpendicular to it has other extrema:
// from the very point that belongs to the shift, which as a float of up to 16 could not be made better.
void torus_refine(inout torus_Line line) {
    TORUS_PRECISE vec3 d = line.direction;
    vec3 low;
    TORUS_PRECISE vec3 beside = torus_advance3(line.base, line.baseLow, line.shift, 0.0, d, low);
    TORUS_PRECISE float rest = -(beside.x * d.x + beside.y * d.y + beside.z * d.z) * line.perLength2;
    TORUS_PRECISE vec3 foot = beside + rest * d;
    TORUS_PRECISE float lower = line.lower - rest;
    TORUS_PRECISE float upper = line.upper - rest;
    line.foot = foot;
    line.shiftRest = rest;
    line.lower = lower;
    line.upper = upper;
}

#endif
