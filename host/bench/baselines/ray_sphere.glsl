// SPDX-License-Identifier: MIT
// Baseline: the floor: the bounding sphere, which cannot be right.
//
// The bounding sphere in the torus' place, with the closest point taken as a vector (Haines, Guenther,
// Akenine-Möller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019, chapter 7). Its answers
// are those of a sphere, and nobody can ask less of a torus.
#ifndef RAY_SPHERE_GLSL
#define RAY_SPHERE_GLSL

#include "torus/torus.glsl"

// Both roots, in lengths of the direction.
bool raySphereRoots(Torus torus, vec3 origin, vec3 direction, out float near, out float far) {
    float reach = torus.majorRadius + torus.minorRadius;
    float perDd = 1.0 / dot(direction, direction);
    float middle = -dot(origin, direction) * perDd;
    vec3 foot = origin + middle * direction;
    float square = reach * reach - dot(foot, foot);
    float halfChord = sqrt(max(square, 0.0) * perDd);
    near = middle - halfChord;
    far = middle + halfChord;
    return square >= 0.0;
}

bool raySphereIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    hit = torus_miss(tMax);
    float near;
    float far;
    bool meets = raySphereRoots(torus, origin, direction, near, far);
    float t = near >= tMin ? near : far;
    if (!(meets && t >= tMin && t <= tMax)) {
        return false;
    }
    hit = TorusHit(t, origin + t * direction);
    return true;
}

bool raySphereOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    float near;
    float far;
    bool meets = raySphereRoots(torus, origin, direction, near, far);
    float t = near >= tMin ? near : far;
    return meets && t >= tMin && t <= tMax;
}

int raySphereIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    for (int i = 0; i < 4; ++i) {
        hits[i] = torus_miss(tMax);
    }
    float near;
    float far;
    if (!raySphereRoots(torus, origin, direction, near, far)) {
        return 0;
    }
    bool hitsNear = near >= tMin && near <= tMax;
    bool hitsFar = far >= tMin && far <= tMax;
    TorusHit atNear = TorusHit(near, origin + near * direction);
    TorusHit atFar = TorusHit(far, origin + far * direction);
    if (hitsNear) {
        hits[0] = atNear;
    } else if (hitsFar) {
        hits[0] = atFar;
    }
    if (hitsNear && hitsFar) {
        hits[1] = atFar;
    }
    return int(hitsNear) + int(hitsFar);
}

#define RAY_INTERSECT raySphereIntersect
#define RAY_OCCLUDED raySphereOccluded
#define RAY_INTERSECT_ALL raySphereIntersectAll

#endif
