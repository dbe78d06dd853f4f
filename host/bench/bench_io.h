// SPDX-License-Identifier: MIT
// What the benchmark and its shaders agree on.
#ifndef RAYTORUS_BENCH_IO_H
#define RAYTORUS_BENCH_IO_H

#define BENCH_BINDING_WORDS 0

// A workgroup is a tile of 8 x 8 invocations, and each of them takes 64 rays, one after the other: those of the same
// place in 64 tiles. So a workgroup has a block of 64 x 64 rays. Workgroups have two coordinates in the picture; along
// the third, the layers, every one does the same rays again.
#define BENCH_TILE_SIDE 8
#define BENCH_GROUP_SIZE 64
#define BENCH_TILES_A_SIDE 8
#define BENCH_RAYS_EACH 64
#define BENCH_GROUP_RAYS 4096
#define BENCH_BLOCK_SIDE 64

// Specialization constants.
#define BENCH_CONSTANT_QUERY 0
#define BENCH_CONSTANT_SCATTERED 1
#define BENCH_CONSTANT_TASK 2

// What to do with the rays: answer them and add up the bits of the answers, a word an invocation; write the rays, as
// trace.comp reads them; answer them and write the answers, as trace.comp writes them, but for the normal.
#define BENCH_TASK_TIME 0
#define BENCH_TASK_RAYS 1
#define BENCH_TASK_ANSWERS 2

#define BENCH_NEAREST_FLOATS 5

#endif
