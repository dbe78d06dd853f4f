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

// The points base + baseLow + (shift + u) * direction. One unit is the power of two at or below R + r, so
// R + r is in [1, 2).
struct torus_Line {
    bool meets;            // false: no part of the ray is in the bounding sphere
    float majorRadius;     // R in units
    float minorRadius;     // r in units
    vec3 foot;             // the point u = 0, which is closest to the centre, to some 3e-7
    vec3 base;             // the origin, in units; or a point near the foot ...
    vec3 baseLow;          // ... and what its rounding took away
    float baseShift;       // from the origin to the base, in lengths of `direction`
    float shift;           // from the base to the foot
    vec3 direction;
    float length2;         // its squared length
    float enter;           // where the line can be in the torus: in its bounding sphere and, once cut, between
    float leave;           //   z = -r and z = r. Outside the torus at both ends
    float lower;           // the searched interval of u: what [tMin, tMax] leaves of that
    float upper;
    float halfChord;       // the bounding sphere spans [-halfChord, halfChord]
    float tPerU;           // t = (baseShift + shift + u) * tPerU
    float unit;            // length of one unit
};

// Room around the bounding sphere, relative to its squared radius. A ray in the plane z = 0 meets sphere and torus in
// the same point: rounding (some 2^-22) must not put the torus' root outside the searched interval.
#define TORUS_SPHERE_ROOM 1.00001

// Room around what a ray is tested against before anything of it is known exactly, in units: some ten roundings.
#define TORUS_ROOM 2.0e-6

// An origin with a coordinate beyond this, in units, is far away.
#define TORUS_AFAR 8.0

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

// A ray in units, and whether it is worth reducing.
struct torus_Ray {
    bool meets;           // false: bad input, or the ray passes the bounding sphere by
    float majorRadius;
    float minorRadius;
    vec3 origin;
    vec3 direction;       // as given, scaled by a power of two: its longest component is in [1, 2)
    float length2;        // its squared length
    float perLength2;
    float shift;          // from the origin to the point closest to the centre, roughly, in lengths of `direction`
    float unit;
    float tPerU;
    float uPerT;
};

// A ray in units. What is known of it is computed for every ray, and no branch of this file returns early: compilers
// carry each value that a branch may or may not have set through memory, from there to its last use.
torus_Ray torus_scale(float majorRadius, float minorRadius, vec3 origin, float tMin, vec3 direction, float tMax) {
    float sizeUnit = torus_powerOfTwoBelow(majorRadius + minorRadius);
    float longest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
    float longestUnit = torus_powerOfTwoBelow(longest);
    // Outside these ranges the reciprocals of the units, or their quotient, would leave float32. The unit of 1e-18 is
    // 2^-60.
    bool valid = minorRadius > 0.0 && majorRadius >= 0.0 && sizeUnit >= 8.0e-19 && sizeUnit <= 1.0e18 &&
                 longestUnit >= 1.0e-19 && longestUnit <= 1.0e19;
    float unit = valid ? sizeUnit : 1.0;
    float directionUnit = valid ? longestUnit : 1.0;
    TORUS_PRECISE float perUnit = torus_powerOfTwoReciprocal(unit);
    TORUS_PRECISE float perDirectionUnit = torus_powerOfTwoReciprocal(directionUnit);
    TORUS_PRECISE vec3 o = origin * perUnit;
    TORUS_PRECISE vec3 d = direction * perDirectionUnit;
    // The direction stays as given, because normalising it would turn the ray by an ulp, which far away is more than
    // the torus' own rounding.
    TORUS_PRECISE float dd = d.x * d.x + d.y * d.y + d.z * d.z;
    // Nothing waits for the division but what is in the branch.
    TORUS_PRECISE float perDd = 1.0 / dd;
    TORUS_PRECISE float shift = -(o.x * d.x + o.y * d.y + o.z * d.z) * perDd;
    TORUS_PRECISE float R = majorRadius * perUnit;
    TORUS_PRECISE float r = minorRadius * perUnit;
    // Most rays that miss pass the bounding sphere by, and by more than rounding could be wrong. Their distance from the
    // centre by the moment, which needs no division.
    TORUS_PRECISE float momentX = o.y * d.z - o.z * d.y;
    TORUS_PRECISE float momentY = o.z * d.x - o.x * d.z;
    TORUS_PRECISE float momentZ = o.x * d.y - o.y * d.x;
    TORUS_PRECISE float moment2 = momentX * momentX + momentY * momentY + momentZ * momentZ;
    TORUS_PRECISE float around = (R + r) * 1.00001 + 1.0e-6 * (abs(o.x) + abs(o.y) + abs(o.z));
    TORUS_PRECISE float around2 = around * around * dd;
    // Both are powers of two: no bit of t is lost on the way.
    TORUS_PRECISE float tPerU = unit * perDirectionUnit;
    TORUS_PRECISE float uPerT = directionUnit * perUnit;
    bool meets = valid && tMin <= tMax && moment2 <= around2;
    return torus_Ray(meets, R, r, o, d, dd, perDd, shift, unit, tPerU, uPerT);
}

// Reduces a ray that may meet the bounding sphere.
torus_Line torus_reduce(torus_Ray ray, float tMin, float tMax) {
    TORUS_PRECISE vec3 o = ray.origin;
    TORUS_PRECISE vec3 d = ray.direction;
    TORUS_PRECISE float R = ray.majorRadius;
    TORUS_PRECISE float r = ray.minorRadius;
    TORUS_PRECISE float tPerU = ray.tPerU;
    // Move to the foot of the perpendicular. Any parameter near the foot's does as long as the point that belongs to it
    // is known exactly; the second shift takes what the first one's rounding left. The rounding of that is more than
    // the search can do with from afar, and at the tips of horns and spindles.
    TORUS_PRECISE float perDd = ray.perLength2;
    TORUS_PRECISE float firstShift = ray.shift;
    vec3 base = o;
    vec3 baseLow = vec3(0.0, 0.0, 0.0);
    TORUS_PRECISE float baseShift = 0.0;
    TORUS_PRECISE vec3 first = o + firstShift * d;
    TORUS_PRECISE float ring = TORUS_RING * R;
    bool delicate = max(max(abs(o.x), abs(o.y)), abs(o.z)) > TORUS_AFAR || r > ring;
    if (delicate) {
        first = torus_advance3(o, vec3(0.0, 0.0, 0.0), firstShift, 0.0, d, baseLow);
        base = first;
        baseShift = firstShift;
    }
    TORUS_PRECISE float secondShift = -(first.x * d.x + first.y * d.y + first.z * d.z) * perDd;
    TORUS_PRECISE vec3 foot = (first + secondShift * d) + baseLow;
    // Of a point that is but rounded to the foot the line's own u = 0 lies some 3e-7 before or behind: nothing rests on
    // that, as long as all of t, and the ends, are counted from there.
    TORUS_PRECISE float bothShifts = firstShift + secondShift;
    TORUS_PRECISE float shift = delicate ? secondShift : bothShifts;

    TORUS_PRECISE float outer = R + r;
    TORUS_PRECISE float foot2 = foot.x * foot.x + foot.y * foot.y + foot.z * foot.z;
    TORUS_PRECISE float halfChord2 = outer * outer * TORUS_SPHERE_ROOM - foot2;
    TORUS_PRECISE float halfChord = sqrt(max(halfChord2, 0.0) * perDd);
    // Infinite ends are legal; beyond the sphere every end is alike.
    TORUS_PRECISE float baseT = baseShift * tPerU;
    TORUS_PRECISE float footT = shift * tPerU;
    TORUS_PRECISE float begins = ((max(tMin, -TORUS_FLOAT_MAX) - baseT) - footT) * ray.uPerT;
    TORUS_PRECISE float ends = ((min(tMax, TORUS_FLOAT_MAX) - baseT) - footT) * ray.uPerT;
    TORUS_PRECISE float lower = max(begins, -halfChord);
    TORUS_PRECISE float upper = min(ends, halfChord);
    // Where t of the first point is beyond float32, so are the ends of the ray, and their differences no numbers.
    TORUS_PRECISE float tClosest = abs(firstShift) * tPerU;
    bool meets = halfChord2 > 0.0 && lower <= upper && tClosest <= TORUS_FLOAT_MAX;
    return torus_Line(meets, R, r, foot, base, baseLow, baseShift, shift, d, ray.length2, -halfChord, halfChord, lower,
                      upper, halfChord, tPerU, ray.unit);
}

// Cuts the searched interval by the planes z = -r and z = r. Returns whether anything is left of it that is not in the
// hole.
bool torus_cut(inout torus_Line line) {
    TORUS_PRECISE vec3 d = line.direction;
    TORUS_PRECISE float perDz = 1.0 / max(abs(d.z), 1.0e-30);
    TORUS_PRECISE float footZ = d.z < 0.0 ? -line.foot.z : line.foot.z;
    TORUS_PRECISE float slab = line.minorRadius + TORUS_ROOM;
    TORUS_PRECISE float enter = max((-slab - footZ) * perDz, line.enter);
    TORUS_PRECISE float leave = min((slab - footZ) * perDz, line.leave);
    TORUS_PRECISE float lower = max(line.lower, enter);
    TORUS_PRECISE float upper = min(line.upper, leave);
    line.enter = enter;
    line.leave = leave;
    line.lower = lower;
    line.upper = upper;
    // rho is convex: where both ends are in the hole, so is all between.
    TORUS_PRECISE float lowerX = line.foot.x + lower * d.x;
    TORUS_PRECISE float lowerY = line.foot.y + lower * d.y;
    TORUS_PRECISE float upperX = line.foot.x + upper * d.x;
    TORUS_PRECISE float upperY = line.foot.y + upper * d.y;
    TORUS_PRECISE float lowerRho2 = lowerX * lowerX + lowerY * lowerY;
    TORUS_PRECISE float upperRho2 = upperX * upperX + upperY * upperY;
    TORUS_PRECISE float hole = max(line.majorRadius - slab, 0.0);
    TORUS_PRECISE float hole2 = hole * hole;
    return line.meets && lower <= upper && max(lowerRho2, upperRho2) >= hole2;
}

#endif
