// SPDX-License-Identifier: MIT
// A method that answers otherwise when it is asked again: what the benchmark's checksums have to notice. Its
// answers depend on the layer in bench.comp, and in trace.comp on which copy of 4096 rays it has, 64 a workgroup.

#define RAY_INTERSECT fickleIntersect
#define RAY_OCCLUDED torusOccluded
#define RAY_INTERSECT_ALL torusIntersectAll

bool fickleIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit) {
    bool found = torusIntersect(torus, origin, tMin, direction, tMax, hit);
    hit.t *= 1.0 + 1.0e-6 * float(gl_WorkGroupID.z + gl_WorkGroupID.x / 64u);
    return found;
}
