// SPDX-License-Identifier: MIT
// Private: which language this is, and what follows from it.
#ifndef TORUS_LANGUAGE_GLSL
#define TORUS_LANGUAGE_GLSL

// GLSL ES computes with as little as 16 bits unless it is told otherwise.
#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// `precise` forbids the reassociation and contraction that would change bits between drivers and undo error-free
// operations. GLSL has it, and fma(), from 4.00 and ES from 3.20. Who has both by an extension defines TORUS_PRECISE as
// precise before the include; compiled as another language, as whatever says the same there.
#ifndef TORUS_PRECISE
#ifdef GL_ES
#if __VERSION__ < 320
#define TORUS_NO_PRECISE
#define TORUS_NO_FMA
#endif
#else
#if __VERSION__ < 400
#define TORUS_NO_PRECISE
#define TORUS_NO_FMA
#endif
#endif
#endif
#ifdef TORUS_NO_PRECISE
#error no precise in the language: take the single file raytorus.glsl, which is exact without
#endif

// The fast tier needs `precise` in one place alone, and else lets the compiler contract.
#ifndef TORUS_ROUNDED
#define TORUS_ROUNDED precise
#endif
#ifndef TORUS_PRECISE
#ifdef TORUS_FAST
#define TORUS_PRECISE
#else
#define TORUS_PRECISE precise
#endif
#endif

// Whether doubts are decided and crossings refined by sums of two floats.
#ifdef TORUS_FAST
#define TORUS_EXACT false
#else
#define TORUS_EXACT true
#endif

#endif
