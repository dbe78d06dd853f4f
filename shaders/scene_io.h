// SPDX-License-Identifier: MIT
// What host and shaders exchange: binding numbers, specialization constants and structures, compiled by both, so that
// a layout cannot drift. Everything is made of vec4, uvec4 and ivec4: std140, std430 and C++ agree on those.
#ifndef RAYTORUS_SCENE_IO_H
#define RAYTORUS_SCENE_IO_H

#ifdef __cplusplus
#include <glm/vec4.hpp>
namespace raytorus::scene_io {
using glm::ivec4;
using glm::uvec4;
using glm::vec4;
#endif

// Set 0 of the picture shaders.
#define SCENE_BINDING_FRAME 0
#define SCENE_BINDING_TORI 1
#define SCENE_BINDING_NODES 2
#define SCENE_BINDING_MATERIALS 3
// The compute route's pictures; the fragment route's are its colour attachments, in the same order.
#define SCENE_BINDING_COLOR 4
#define SCENE_BINDING_POSITION 5
#define SCENE_BINDING_NORMAL 6
#define SCENE_BINDING_SURFACE 7

// Large scenes: storage buffers of any length in place of the uniform blocks, which hold this many.
#define SCENE_BINDING_TORI_LARGE 8
#define SCENE_BINDING_NODES_LARGE 9
#define SCENE_BINDING_MATERIALS_LARGE 10
#define SCENE_SMALL_TORI 512
#define SCENE_SMALL_NODES 1024
#define SCENE_SMALL_MATERIALS 256

// Specialization constants. What loops and branches depend on is here and not in a uniform block: lavapipe compiles
// a fragment shader anew for each submission if its control flow depends on one.
#define SCENE_CONSTANT_AOVS 0     // bool: the geometric pictures too, or the colour alone
#define SCENE_CONSTANT_SIDE 1     // samples along each side of a pixel
#define SCENE_CONSTANT_LIGHTS 2   // number of lights
#define SCENE_CONSTANT_TORI 3     // number of tori; 1 needs no hierarchy
#define SCENE_CONSTANT_STORAGE 4  // SCENE_STORAGE_UNIFORM or SCENE_STORAGE_BUFFER
#define SCENE_STORAGE_UNIFORM 0
#define SCENE_STORAGE_BUFFER 1

// Workgroup of the compute route.
#define SCENE_GROUP_WIDTH 8
#define SCENE_GROUP_HEIGHT 8

#define SCENE_MAX_LIGHTS 16

struct SceneLight {
    vec4 vector;  // xyz: towards the light (w = 0, unit) or its position (w = 1)
    vec4 color;   // rgb: radiance (directional) or intensity (point)
};

struct SceneFrame {
    vec4 cameraPosition;
    vec4 cameraForward;  // direction of the ray through (x, y) in [-1, 1]^2: forward + x right + y up
    vec4 cameraRight;
    vec4 cameraUp;
    vec4 backgroundTop;
    vec4 backgroundBottom;
    vec4 ambientSky;
    vec4 ambientGround;
    vec4 size;  // width, height, 0, 0
    SceneLight lights[SCENE_MAX_LIGHTS];
};

// World to torus frame: p' = row * (p - origin), with the radii in world units. In the order of the BVH's leaves.
struct SceneTorus {
    vec4 row0;    // xyz: row of the rotation, w: origin.x
    vec4 row1;    // w: origin.y
    vec4 row2;    // w: origin.z
    vec4 radii;   // majorRadius, minorRadius, 0, 0
    ivec4 names;  // index in the scene, material, 0, 0
};

// A node of the bounding volume hierarchy, depth first. See host/scene/bvh.hpp.
struct SceneNode {
    vec4 minimum;  // w: the bits of `skip`, the node after this subtree
    vec4 maximum;  // w: the bits of `primitive`, the torus of a leaf or -1
};

struct SceneMaterial {
    vec4 diffuse;         // rgb reflectance; w: roughness
    vec4 specular;        // rgb reflectance at normal incidence; w: 0
    vec4 checkerDiffuse;  // rgb of every other field; w: 0
    vec4 checkerCounts;   // fields round the axis and round the tube; 0: no checker
};

#ifdef __cplusplus
}  // namespace raytorus::scene_io
#endif

#endif
