// SPDX-License-Identifier: MIT
// What groups.cpp and its shaders agree on.
#ifndef RAYTORUS_GROUPS_IO_H
#define RAYTORUS_GROUPS_IO_H

// count_passes.comp tells the steps of so many passes, each by so many bits; a pass has at most four.
#define GROUPS_PASSES 8
#define GROUPS_BITS_OF_A_PASS 4
#define GROUPS_REFINEMENTS_SHIFT 8

// Which part of the library part.comp has.
#define GROUPS_CONSTANT_PART 0
#define GROUPS_PART_NONE 0
#define GROUPS_PART_ENDS 1
#define GROUPS_PART_STEP 2
#define GROUPS_PART_REFINEMENT 3

#endif
