// SPDX-License-Identifier: MIT
// Private: exact float32 building blocks. Only + - * / sqrt, comparisons and integer operations on bit patterns.
#ifndef TORUS_ARITHMETIC_GLSL
#define TORUS_ARITHMETIC_GLSL

// `precise` forbids the reassociation and contraction that would change bits between drivers and undo error-free
// transformations. Compiled as another language, define it before the include as whatever says the same there.
#ifndef TORUS_PRECISE
#define TORUS_PRECISE precise
#endif

// Largest finite float32: what `tMax = infinity` is read as, so that nothing non-finite enters the arithmetic.
#define TORUS_FLOAT_MAX 3.4028234e38

// The power of two at or below a positive normal x; 0 for a denormal one.
float torus_powerOfTwoBelow(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0x7f800000u);
}

// 1 / x for a power of two from 2^-126 to 2^126, exactly and without a division.
float torus_powerOfTwoReciprocal(float x) {
    return uintBitsToFloat(0x7f000000u - floatBitsToUint(x));
}

// a * b - product, exactly, for product = fl(a * b): Dekker's product with Veltkamp's splitting (Numer. Math. 18,
// 1971, pp. 224-242). Not fma: it is unfused on several drivers, where a * b - product would come out as 0.
// Exact while |a|, |b| < 2^100 and the parts do not underflow.
float torus_productError(float a, float b, float product) {
    TORUS_PRECISE float aScaled = 4097.0 * a;
    TORUS_PRECISE float aHigh = aScaled - (aScaled - a);
    TORUS_PRECISE float aLow = a - aHigh;
    TORUS_PRECISE float bScaled = 4097.0 * b;
    TORUS_PRECISE float bHigh = bScaled - (bScaled - b);
    TORUS_PRECISE float bLow = b - bHigh;
    TORUS_PRECISE float error = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
    return error;
}

// base + factor * direction, rounded as if the product were exact: where the sum cancels, as it does when a far
// origin is moved to the centre, the result keeps the precision of its own size instead of the origin's.
float torus_shift(float base, float factor, float direction) {
    TORUS_PRECISE float product = factor * direction;
    TORUS_PRECISE float sum = base + product;
    // Knuth's two-sum: the part of base + product that `sum` lost.
    TORUS_PRECISE float productInSum = sum - base;
    TORUS_PRECISE float sumError = (base - (sum - productInSum)) + (product - productInSum);
    TORUS_PRECISE float shifted = sum + (sumError + torus_productError(factor, direction, product));
    return shifted;
}

#endif
