// SPDX-License-Identifier: MIT
// What host and trace.comp exchange. Rays and hits are plain rows of floats, as in the raw files of `raytorus trace`.
#ifndef RAYTORUS_TRACE_IO_H
#define RAYTORUS_TRACE_IO_H

#define TRACE_BINDING_RAYS 0
#define TRACE_BINDING_HITS 1

// A ray: origin, tMin, direction, tMax.
#define TRACE_RAY_FLOATS 8
// The nearest hit: hit (1 or 0), t, position, normal.
#define TRACE_NEAREST_FLOATS 8
// All hits: their number, t of four, position of four.
#define TRACE_ALL_FLOATS 17
// Any hit: 1 or 0.
#define TRACE_ANY_FLOATS 1

// Specialization constant: what is asked.
#define TRACE_CONSTANT_QUERY 0
#define TRACE_QUERY_NEAREST 0
#define TRACE_QUERY_ALL 1
#define TRACE_QUERY_ANY 2

#define TRACE_GROUP_SIZE 64

#endif
