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

// 1 / x for a power of two from 2^-126 to 2^126, exactly and without a division.
float torus_powerOfTwoReciprocal(float x) {
    return uintBitsToFloat(0x7f000000u - floatBitsToUint(x));
}

// The first 12 of a float's 24 bits; the rest, which is the difference, has the other 12.
float torus_upperHalf(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}

// x + one of these - the same is x rounded to a multiple of 2^-8, 2^-10 or 2^-11. The sum has to stay in its binade: x may
// be a third of it.
#define TORUS_TO_8_BITS 49152.0
#define TORUS_TO_10_BITS 12288.0
#define TORUS_TO_11_BITS 6144.0
float torus_rounded(float x, float magic) {
    TORUS_PRECISE float sum = x + magic;
    TORUS_PRECISE float rounded = sum - magic;
    return rounded;
}

vec3 torus_rounded3(vec3 x, float magic) {
    TORUS_PRECISE vec3 sum = x + magic;
    TORUS_PRECISE vec3 rounded = sum - magic;
    return rounded;
}

// a * b - product, exactly, for product = fl(a * b): Dekker's product (Numer. Math. 18, 1971, pp. 224-242), split by
// bits, which takes half the operations of splitting by a multiplication, and no result out of range: products of
// halves have 24 bits, and so has each of these sums. Exact unless the parts underflow. Not by fma() unless asked for:
// it is unfused on several drivers, where it would return 0.
float torus_productError(float a, float b, float product) {
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

// a + b - sum, exactly, for sum = fl(a + b): Knuth's two-sum (The Art of Computer Programming 2, 4.2.2, theorem B).
float torus_sumError(float a, float b, float sum) {
    TORUS_PRECISE float bInSum = sum - a;
    TORUS_PRECISE float error = (a - (sum - bInSum)) + (b - bInSum);
    return error;
}

// base + factor * direction + little as the unevaluated sum of two floats, of which the first is the rounded result:
// where the sum cancels, as it does when a far origin is moved to the centre, nothing is lost.
float torus_advance(float base, float factor, float direction, float little, out float low) {
    TORUS_PRECISE float product = factor * direction;
    TORUS_PRECISE float sum = base + product;
    TORUS_PRECISE float rest =
        (torus_sumError(base, product, sum) + torus_productError(factor, direction, product)) + little;
    TORUS_PRECISE float high = sum + rest;
    TORUS_PRECISE float lost = rest - (high - sum);
    low = lost;
    return high;
}

// a^2 + b^2 - c^2 where the first two nearly make up the third, to some 2^-47 of c^2: the larger of a^2 and b^2 less
// c^2 is exact (Sterbenz) unless both are less than half of c^2, and what it loses then (Dekker's sum, of which the
// second is the larger), as the squares' own roundings, is known exactly.
float torus_squareDifference(float a, float b, float c) {
    TORUS_PRECISE float aa = a * a;
    TORUS_PRECISE float bb = b * b;
    TORUS_PRECISE float cc = c * c;
    TORUS_PRECISE float errors =
        (torus_productError(a, a, aa) + torus_productError(b, b, bb)) - torus_productError(c, c, cc);
    TORUS_PRECISE float larger = max(aa, bb);
    TORUS_PRECISE float rest = larger - cc;
    TORUS_PRECISE float lost = larger - (rest + cc);
    TORUS_PRECISE float difference = (rest + min(aa, bb)) + (errors + lost);
    return difference;
}

#endif
