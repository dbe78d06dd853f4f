// SPDX-License-Identifier: MIT
// Private: numbers as the unevaluated sum of two floats, by error-free sums and products.
//
// Only + - * / sqrt, comparisons and integer operations on bit patterns.
#ifndef TORUS_DOUBLE_FLOAT_GLSL
#define TORUS_DOUBLE_FLOAT_GLSL

#include "language.glsl"

// The largest finite float32. An infinite tMax is read as this, so that nothing non-finite enters the arithmetic. Not a
// decimal number: some compilers round it up, and others refuse it then.
#define TORUS_FLOAT_MAX uintBitsToFloat(0x7f7fffffu)

// 1 / x for a power of two from 2^-126 to 2^126, exactly and without a division.
float torus_invPowerOfTwo(float x) {
    return uintBitsToFloat(0x7f000000u - floatBitsToUint(x));
}

// The first 12 of a float's 24 bits. The difference from the float has the other 12.
float torus_upperHalf(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}

// a * b - product, exactly, for product = fl(a * b): Dekker's product (Numer. Math. 18, 1971, pp. 224-242). The factors
// are split by bits, which costs half the operations of a split by multiplication. Products of halves have 24 bits, and
// so has each of these sums. Exact unless the parts underflow. fma() is used only where the user says that it rounds
// once: several drivers compute it as a product and a sum, and the error would be 0.
float torus_twoProductError(float a, float b, float product) {
#ifdef TORUS_FUSED_FMA
    TORUS_PRECISE float error = fma(a, b, -product);
#else
    TORUS_PRECISE float aHigh = torus_upperHalf(a);
    TORUS_PRECISE float aLow = a - aHigh;
    TORUS_PRECISE float bHigh = torus_upperHalf(b);
    TORUS_PRECISE float bLow = b - bHigh;
    TORUS_PRECISE float error = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
#endif
    return error;
}

// a * a - square, exactly, for square = fl(a * a): the same for equal factors.
float torus_squareError(float a, float square) {
#ifdef TORUS_FUSED_FMA
    TORUS_PRECISE float error = fma(a, a, -square);
#else
    TORUS_PRECISE float high = torus_upperHalf(a);
    TORUS_PRECISE float low = a - high;
    TORUS_PRECISE float error = ((high * high - square) + (2.0 * high) * low) + low * low;
#endif
    return error;
}

// a + b - sum, exactly, for sum = fl(a + b): Knuth's two-sum (The Art of Computer Programming 2, 4.2.2, theorem B).
float torus_twoSumError(float a, float b, float sum) {
    TORUS_PRECISE float bInSum = sum - a;
    TORUS_PRECISE float error = (a - (sum - bInSum)) + (b - bInSum);
    return error;
}

// base + factor * direction + little as the sum of two floats, of which the first is the rounded result. Where base and
// product cancel, as when a far origin moves to the torus, nothing is lost.
float torus_advance(float base, float factor, float direction, float little, out float low) {
    TORUS_PRECISE float product = factor * direction;
    TORUS_PRECISE float sum = base + product;
    TORUS_PRECISE float rest = (torus_twoSumError(base, product, sum) +
                                torus_twoProductError(factor, direction, product)) + little;
    TORUS_PRECISE float high = sum + rest;
    TORUS_PRECISE float lost = rest - (high - sum);
    low = lost;
    return high;
}

// The same for each component of base + baseLow + (factor + factorLow) * direction.
vec3 torus_advance3(vec3 base, vec3 baseLow, float factor, float factorLow, vec3 direction, out vec3 low) {
    TORUS_PRECISE vec3 little = baseLow + factorLow * direction;
    float lowX;
    float lowY;
    float lowZ;
    float x = torus_advance(base.x, factor, direction.x, little.x, lowX);
    float y = torus_advance(base.y, factor, direction.y, little.y, lowY);
    float z = torus_advance(base.z, factor, direction.z, little.z, lowZ);
    low = vec3(lowX, lowY, lowZ);
    return vec3(x, y, z);
}

// a^2 + b^2 - c^2 where the first two nearly make up the third, to some 2^-47 of c^2. The larger of a^2 and b^2 less c^2
// is exact (Sterbenz) unless both are less than half of c^2. What it loses then (Dekker's sum, of which the second is the
// larger) is known exactly, and so are the roundings of the squares.
float torus_squareDifference(float a, float b, float c) {
    TORUS_PRECISE float aa = a * a;
    TORUS_PRECISE float bb = b * b;
    TORUS_PRECISE float cc = c * c;
    TORUS_PRECISE float errors = (torus_squareError(a, aa) + torus_squareError(b, bb)) - torus_squareError(c, cc);
    TORUS_PRECISE float larger = max(aa, bb);
    TORUS_PRECISE float rest = larger - cc;
    TORUS_PRECISE float lost = larger - (rest + cc);
    TORUS_PRECISE float difference = (rest + min(aa, bb)) + (errors + lost);
    return difference;
}

#endif
