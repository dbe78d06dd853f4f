// SPDX-License-Identifier: MIT
// Method: marching along the distance to the surface, to 1e-4 r.
// Tolerance: 1e-3 (R + r).
//
// Sphere tracing (Hart, The Visual Computer 12, 1996, pp. 527-545): from where the ray meets the bounding sphere, step by
// the distance to the surface, which nothing can be nearer than, until it is less than 1e-4 r. Marching starts anew at
// the sphere, so a far origin costs one rounding of the start and no more; from inside the solid the absolute
// distance leads out. In plain float32, as it is usually written.
//
// What it loses: digits (a hit is up to 1e-4 r early, and more along the ray where it slants), and hits that 128 steps do
// not reach: where the ray passes the surface by closely, and where it slants by less than some 8 degrees.
#ifndef SPHERE_TRACING_GLSL
#define SPHERE_TRACING_GLSL

#include "torus/torus.glsl"

#define SPHERE_TRACING_STEPS 128
#define SPHERE_TRACING_NEAR 1.0e-4
// The longest step across a surface, in r: less than any gap or chord that is no graze.
#define SPHERE_TRACING_ACROSS 0.05

// The bounding sphere, in R + r: so that rounding does not cut off a hit where torus and sphere touch.
#define SPHERE_TRACING_ROOM 1.0001

struct SphereTracing {
    vec3 base;        // where marching starts
    vec3 direction;   // unit
    float start;      // t of base, in lengths of the unit direction
    float extent;     // of the way to march
    float perSize;    // 1 / length of the direction as given
    float side;       // -1 if base is inside, else 1
};

bool sphereTracingPrepare(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out SphereTracing ray) {
    float size = length(direction);
    ray.perSize = 1.0 / size;
    ray.direction = direction * ray.perSize;
    float reach = SPHERE_TRACING_ROOM * (torus.majorRadius + torus.minorRadius);
    // The distance of the line from the centre by the vector, not by the difference of two far squares (Haines,
    // Guenther, Akenine-Möller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019, chapter 7).
    float along = dot(origin, ray.direction);
    vec3 foot = origin - along * ray.direction;
    float half2 = reach * reach - dot(foot, foot);
    float halfChord = sqrt(max(half2, 0.0));
    float enters = -along - halfChord;
    ray.start = max(tMin * size, enters);
    ray.base = origin + ray.start * ray.direction;
    ray.extent = min(tMax * size, halfChord - along) - ray.start;
    ray.side = ray.start > enters && torusDistance(torus, ray.base) < 0.0 ? -1.0 : 1.0;
    return size > 0.0 && size <= TORUS_FLOAT_MAX && torus.minorRadius > 0.0 && torus.majorRadius >= 0.0 &&
           reach <= TORUS_FLOAT_MAX && tMin <= tMax && half2 > 0.0 && ray.extent >= 0.0;
}

// To the next surface at or beyond s.
bool sphereTracingMarch(Torus torus, SphereTracing ray, inout float s) {
    float near = SPHERE_TRACING_NEAR * torus.minorRadius;
    for (int i = 0; i < SPHERE_TRACING_STEPS && s <= ray.extent; ++i) {
        TORUS_ON_STEP
        float distance = ray.side * torusDistance(torus, ray.base + s * ray.direction);
        if (distance < near) {
            return true;
        }
        s += distance;
    }
    return false;
}

// Away from a surface just met, to whichever side.
void sphereTracingCross(Torus torus, SphereTracing ray, inout float s, out float side) {
    float near = SPHERE_TRACING_NEAR * torus.minorRadius;
    float step = 2.0 * near;
    side = ray.side;
    for (int i = 0; i < SPHERE_TRACING_STEPS; ++i) {
        s += step;
        float distance = torusDistance(torus, ray.base + s * ray.direction);
        if (abs(distance) > near) {
            side = distance < 0.0 ? -1.0 : 1.0;
            return;
        }
        step = min(2.0 * step, SPHERE_TRACING_ACROSS * torus.minorRadius);
    }
}

TorusHit sphereTracingHit(SphereTracing ray, float s, float tMin, float tMax) {
    return TorusHit(clamp((ray.start + s) * ray.perSize, tMin, tMax), ray.base + s * ray.direction);
}

bool sphereTracingIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = torus_miss(tMax);
    SphereTracing ray;
    float s = 0.0;
    if (!sphereTracingPrepare(torus, origin, tMin, direction, tMax, ray) || !sphereTracingMarch(torus, ray, s)) {
        return false;
    }
    hit = sphereTracingHit(ray, s, tMin, tMax);
    return true;
}

bool sphereTracingOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    SphereTracing ray;
    float s = 0.0;
    return sphereTracingPrepare(torus, origin, tMin, direction, tMax, ray) && sphereTracingMarch(torus, ray, s);
}

int sphereTracingIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    SphereTracing ray;
    if (!sphereTracingPrepare(torus, origin, tMin, direction, tMax, ray)) {
        return 0;
    }
    float s = 0.0;
    int count = 0;
    while (count < 4 && sphereTracingMarch(torus, ray, s)) {
        hits[count] = sphereTracingHit(ray, s, tMin, tMax);
        ++count;
        float side;
        sphereTracingCross(torus, ray, s, side);
        // Back on the same side: a graze, into the solid and out of it within the stopping distance.
        if (side == ray.side && count < 4 && s <= ray.extent) {
            hits[count] = sphereTracingHit(ray, s, tMin, tMax);
            ++count;
        }
        ray.side = side;
    }
    return count;
}

#define RAY_INTERSECT sphereTracingIntersect
#define RAY_OCCLUDED sphereTracingOccluded
#define RAY_INTERSECT_ALL sphereTracingIntersectAll

#endif
