#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by marching along the distance to the surface.

#include "sphere_tracing.glsl"

#define TRACE_INTERSECT sphereTracingIntersect
#define TRACE_OCCLUDED sphereTracingOccluded
#define TRACE_INTERSECT_ALL sphereTracingIntersectAll
#include "trace.glsl"
