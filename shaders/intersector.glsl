// SPDX-License-Identifier: MIT
// Who answers the rays of trace.comp and of the scenes: the library, or what CompileShader.cmake's INTERSECTOR names, a
// file that defines functions with the signatures of torusIntersect, torusOccluded and torusIntersectAll, and these
// macros with their names.
#ifndef INTERSECTOR_GLSL
#define INTERSECTOR_GLSL

#include "torus/torus.glsl"

#ifdef OTHER_INTERSECTOR
#include "other_intersector.glsl"
#else
#define RAY_INTERSECT torusIntersect
#define RAY_OCCLUDED torusOccluded
#define RAY_INTERSECT_ALL torusIntersectAll
#endif

#endif
