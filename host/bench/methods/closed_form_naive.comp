#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by the formula of the quartic in world space.

#include "closed_form_naive.glsl"

#define TRACE_INTERSECT naiveIntersect
#define TRACE_OCCLUDED naiveOccluded
#define TRACE_INTERSECT_ALL naiveIntersectAll
#include "trace.glsl"
