// SPDX-License-Identifier: MIT
// Who answers the rays of trace.comp and of the scenes: the library, or what CompileShader.cmake's METHOD names, a
// file that defines functions with the signatures of torusIntersect, torusOccluded and torusIntersectAll, and these
// macros with their names.
#ifndef METHOD_GLSL
#define METHOD_GLSL

// For looking at the cost of rays: RAY_STEPS is the number of steps of all loops since RAY_STEPS_BEGIN.
#ifdef COUNT_STEPS
int rayStepCount = 0;
#define TORUS_ON_STEP rayStepCount += 1;
#define RAY_STEPS_BEGIN rayStepCount = 0;
#define RAY_STEPS float(rayStepCount)
#else
#define RAY_STEPS_BEGIN
#define RAY_STEPS 0.0
#endif

#include "torus/torus.glsl"

#ifdef OTHER_METHOD
#include "other_method.glsl"
#else
#define RAY_INTERSECT torusIntersect
#define RAY_OCCLUDED torusOccluded
#define RAY_INTERSECT_ALL torusIntersectAll
#endif

#endif
