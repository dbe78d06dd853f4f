// SPDX-License-Identifier: MIT
// The scene's buffers, and rays through it: bounding volume hierarchy, then the torus library. All in world space.
#ifndef SCENE_GLSL
#define SCENE_GLSL

#include "method.glsl"
#include "scene_io.h"

layout(constant_id = SCENE_CONSTANT_TORI) const int sceneTori = 1;
layout(constant_id = SCENE_CONSTANT_STORAGE) const int sceneStorage = SCENE_STORAGE_UNIFORM;

layout(set = 0, binding = SCENE_BINDING_FRAME, std140) uniform FrameBlock { SceneFrame frame; };
layout(set = 0, binding = SCENE_BINDING_TORI, std140) uniform ToriBlock { SceneTorus smallTori[SCENE_SMALL_TORI]; };
layout(set = 0, binding = SCENE_BINDING_NODES, std140) uniform NodesBlock { SceneNode smallNodes[SCENE_SMALL_NODES]; };
layout(set = 0, binding = SCENE_BINDING_MATERIALS, std140) uniform MaterialsBlock {
    SceneMaterial smallMaterials[SCENE_SMALL_MATERIALS];
};
layout(set = 0, binding = SCENE_BINDING_TORI_LARGE, std430) readonly buffer LargeToriBlock { SceneTorus largeTori[]; };
layout(set = 0, binding = SCENE_BINDING_NODES_LARGE, std430) readonly buffer LargeNodesBlock {
    SceneNode largeNodes[];
};
layout(set = 0, binding = SCENE_BINDING_MATERIALS_LARGE, std430) readonly buffer LargeMaterialsBlock {
    SceneMaterial largeMaterials[];
};

// Uniform blocks are several times faster to read than storage buffers on a CPU, and no slower elsewhere.
SceneTorus sceneTorus(int index) {
    if (sceneStorage == SCENE_STORAGE_BUFFER) {
        return largeTori[index];
    }
    return smallTori[sceneTori == 1 ? 0 : index];
}

SceneNode sceneNode(int index) {
    if (sceneStorage == SCENE_STORAGE_BUFFER) {
        return largeNodes[index];
    }
    return smallNodes[index];
}

SceneMaterial sceneMaterial(int index) {
    if (sceneStorage == SCENE_STORAGE_BUFFER) {
        return largeMaterials[index];
    }
    return smallMaterials[index];
}

struct SceneRay {
    vec3 origin;
    vec3 direction;
    vec3 perDirection;  // 1 / direction, finite
};

struct SceneHit {
    int torus;  // in the order of the buffer; -1: none
    float t;
    vec3 position;  // in the torus' frame
};

vec3 sceneToTorus(SceneTorus torus, vec3 v) {
    precise float x = torus.row0.x * v.x + torus.row0.y * v.y + torus.row0.z * v.z;
    precise float y = torus.row1.x * v.x + torus.row1.y * v.y + torus.row1.z * v.z;
    precise float z = torus.row2.x * v.x + torus.row2.y * v.y + torus.row2.z * v.z;
    return vec3(x, y, z);
}

vec3 sceneFromTorus(SceneTorus torus, vec3 v) {
    precise vec3 world = v.x * torus.row0.xyz + v.y * torus.row1.xyz + v.z * torus.row2.xyz;
    return world;
}

vec3 sceneOriginOf(SceneTorus torus) {
    return vec3(torus.row0.w, torus.row1.w, torus.row2.w);
}

SceneRay sceneMakeRay(vec3 origin, vec3 direction) {
    // A component of zero becomes one so small that the slab it belongs to is decided by the origin alone.
    const float tiny = 1.0e-20;
    vec3 safe = vec3(abs(direction.x) > tiny ? direction.x : tiny, abs(direction.y) > tiny ? direction.y : tiny,
                     abs(direction.z) > tiny ? direction.z : tiny);
    precise vec3 perDirection = 1.0 / safe;
    return SceneRay(origin, direction, perDirection);
}

// Widened by a few roundings of its own distances, as Ize does (Robust BVH Ray Traversal, JCGT 2(2), 2013): a box is
// never missed that the exact ray hits.
bool sceneMeetsBox(SceneRay ray, SceneNode node, float tMin, float tMax) {
    precise vec3 a = (node.minimum.xyz - ray.origin) * ray.perDirection;
    precise vec3 b = (node.maximum.xyz - ray.origin) * ray.perDirection;
    vec3 near = min(a, b);
    vec3 far = max(a, b);
    precise float enter = max(max(near.x, near.y), near.z);
    precise float leave = min(min(far.x, far.y), far.z);
    precise float room = 4.0e-7 * max(abs(enter), abs(leave));
    return enter - room <= min(leave, tMax) + room && leave + room >= tMin;
}

// Walks from `node` to the next leaf whose box the ray meets; returns its torus, or -1 at the end. The walk is a loop
// of its own so that the lanes of a wave reach the solver together.
int sceneNextTorus(SceneRay ray, float tMin, float tMax, inout int node) {
    if (sceneTori == 1) {  // the solver's own bounding sphere does
        return node++ == 0 ? 0 : -1;
    }
    int found = -1;
    while (node < 2 * sceneTori - 1 && found < 0) {
        SceneNode current = sceneNode(node);
        bool meets = sceneMeetsBox(ray, current, tMin, tMax);
        int primitive = floatBitsToInt(current.maximum.w);
        found = meets ? primitive : -1;
        // A link that does not lead on ends the walk. lavapipe takes the lanes outside the triangle through loops too,
        // and what they read from storage buffers is 0: a walk without end, which its limit of 65535 rounds then ends
        // for the other lanes as well.
        int next = floatBitsToInt(current.minimum.w);
        node = meets && primitive < 0 ? node + 1 : (next > node ? next : 2 * sceneTori);
    }
    return found;
}

SceneHit sceneIntersect(SceneRay ray, float tMin, float tMax) {
    SceneHit nearest = SceneHit(-1, tMax, vec3(0.0));
    int node = 0;
    for (int index = sceneNextTorus(ray, tMin, nearest.t, node); index >= 0;
         index = sceneNextTorus(ray, tMin, nearest.t, node)) {
        SceneTorus torus = sceneTorus(index);
        vec3 origin = sceneToTorus(torus, ray.origin - sceneOriginOf(torus));
        vec3 direction = sceneToTorus(torus, ray.direction);
        TorusHit hit;
        if (RAY_INTERSECT(Torus(torus.radii.x, torus.radii.y), origin, tMin, direction, nearest.t, hit)) {
            nearest = SceneHit(index, hit.t, hit.position);
        }
    }
    return nearest;
}

bool sceneOccluded(SceneRay ray, float tMin, float tMax) {
    int node = 0;
    bool occluded = false;
    for (int index = sceneNextTorus(ray, tMin, tMax, node); index >= 0 && !occluded;
         index = sceneNextTorus(ray, tMin, tMax, node)) {
        SceneTorus torus = sceneTorus(index);
        vec3 origin = sceneToTorus(torus, ray.origin - sceneOriginOf(torus));
        vec3 direction = sceneToTorus(torus, ray.direction);
        occluded = RAY_OCCLUDED(Torus(torus.radii.x, torus.radii.y), origin, tMin, direction, tMax);
    }
    return occluded;
}

// The number of surfaces that the ray crosses, of all tori.
int sceneCount(SceneRay ray, float tMin, float tMax) {
    int node = 0;
    int count = 0;
    for (int index = sceneNextTorus(ray, tMin, tMax, node); index >= 0;
         index = sceneNextTorus(ray, tMin, tMax, node)) {
        SceneTorus torus = sceneTorus(index);
        vec3 origin = sceneToTorus(torus, ray.origin - sceneOriginOf(torus));
        vec3 direction = sceneToTorus(torus, ray.direction);
        TorusHit hits[4];
        count += RAY_INTERSECT_ALL(Torus(torus.radii.x, torus.radii.y), origin, tMin, direction, tMax, hits);
    }
    return count;
}

#endif
