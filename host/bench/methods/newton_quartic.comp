#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by monotone Newton on the reduced quartic.

#include "newton_quartic.glsl"

#define TRACE_INTERSECT newtonQuarticIntersect
#define TRACE_OCCLUDED newtonQuarticOccluded
#define TRACE_INTERSECT_ALL newtonQuarticIntersectAll
#include "trace.glsl"
