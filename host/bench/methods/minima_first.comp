#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by the signs of the reduced quartic at its minima.

#include "minima_first.glsl"

#define TRACE_INTERSECT minimaFirstIntersect
#define TRACE_OCCLUDED minimaFirstOccluded
#define TRACE_INTERSECT_ALL minimaFirstIntersectAll
#include "trace.glsl"
