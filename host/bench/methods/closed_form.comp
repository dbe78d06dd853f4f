#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Rays in, hits out, by the formula of the reduced quartic.

#include "closed_form.glsl"

#define TRACE_INTERSECT closedFormIntersect
#define TRACE_OCCLUDED closedFormOccluded
#define TRACE_INTERSECT_ALL closedFormIntersectAll
#include "trace.glsl"
