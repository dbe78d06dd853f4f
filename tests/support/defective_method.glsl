// SPDX-License-Identifier: MIT
// A method that is wrong on purpose, differently for each ray: what raytorus-verify has to notice.

#define RAY_INTERSECT defectiveIntersect
#define RAY_OCCLUDED defectiveOccluded
#define RAY_INTERSECT_ALL defectiveIntersectAll

// 0 to 7, by the ray.
uint defectOf(vec3 origin) {
    return (floatBitsToUint(origin.x) ^ floatBitsToUint(origin.y)) & 7u;
}

bool defectiveIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    bool found = torusIntersect(torus, origin, tMin, direction, tMax, hit);
    uint defect = defectOf(origin);
    if (defect == 0u) {
        hit.t = uintBitsToFloat(0x7fc00000u);  // NaN
    }
    hit.position.x += defect == 1u ? 0.02 * torus.minorRadius : 0.0;
    return (found || defect == 2u) && defect != 3u;
}

bool defectiveOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax) {
    return torusOccluded(torus, origin, tMin, direction, tMax) != (defectOf(origin) == 4u);
}

int defectiveIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits[4]) {
    int count = torusIntersectAll(torus, origin, tMin, direction, tMax, hits);
    uint defect = defectOf(origin);
    hits[0].position.x += defect == 1u ? 0.02 * torus.minorRadius : 0.0;
    if (defect == 5u && count > 1) {
        TorusHit first = hits[0];
        hits[0] = hits[1];
        hits[1] = first;
    }
    return defect == 6u ? max(count - 1, 0) : count;
}
