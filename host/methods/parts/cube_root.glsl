// SPDX-License-Identifier: MIT
// The cube root from + - * / and the bit pattern: pow has no useful precision guarantee in Vulkan.
#ifndef CUBE_ROOT_GLSL
#define CUBE_ROOT_GLSL

#include "torus/double_float.glsl"

// Of a positive normal x to some 4 %: a third of the exponent, and of the mantissa by the way (Kahan, Computing a Real
// Cube Root, 1991). The constant balances the error.
float cubeRootRough(float x) {
    return uintBitsToFloat(floatBitsToUint(x) / 3u + 0x2a5119f2u);
}

// Of any x, to an ulp or two; 0 for |x| < 1e-37. Two steps of Halley's method, each of which cubes the error.
float cubeRoot(float x) {
    float magnitude = abs(x);
    TORUS_PRECISE float y = cubeRootRough(magnitude);
    for (int i = 0; i < 2; ++i) {
        TORUS_PRECISE float cube = y * y * y;
        y = y * (cube + 2.0 * magnitude) / (2.0 * cube + magnitude);
    }
    TORUS_PRECISE float root = magnitude > 1.0e-37 ? (x < 0.0 ? -y : y) : 0.0;
    return root;
}

#endif
