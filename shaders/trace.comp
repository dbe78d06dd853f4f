#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by the library.

#define TRACE_INTERSECT torusIntersect
#define TRACE_OCCLUDED torusOccluded
#define TRACE_INTERSECT_ALL torusIntersectAll
#include "trace.glsl"
