// SPDX-License-Identifier: MIT
// The double-double arithmetic against 113 bits, operation by operation.
#include "reference/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/random.hpp"

namespace raytorus::reference {

namespace {

Quad exact(const DoubleDouble& x) {
    return Quad(x.high) + Quad(x.low);
}

// Relative error in units of 2^-104, the precision that mantissaBits promises to the root finder.
double errorOf(const DoubleDouble& found, Quad expected) {
    return std::ldexp(std::abs(toDouble((exact(found) - expected) / expected)), 104);
}

// All bits of both parts in use, magnitudes over 2^+-20.
DoubleDouble randomNumber(Random& random) {
    const double high = random.sign() * std::ldexp(random.uniform(0.5, 1), random.below(41) - 20);
    return DoubleDouble::sumOf(high, high * std::ldexp(random.uniform(-0.9, 0.9), -53));
}

}  // namespace

TEST(DoubleDouble, IsAsPreciseAsItSays) {
    double worst[5] = {};
    for (std::uint64_t trial = 0; trial < 100000; ++trial) {
        Random random(30, 0, trial);
        const DoubleDouble x = randomNumber(random), y = randomNumber(random);
        const Quad a = exact(x), b = exact(y);
        const double errors[5] = {errorOf(x + y, a + b), errorOf(x - y, a - b), errorOf(x * y, a * b),
                                  errorOf(x / y, a / b), errorOf(squareRoot(x * x), magnitude(a))};
        // a + b rounds in 113 bits too, but by 2^-9 of the unit here; sums of unlike signs cancel exactly
        // enough
        for (int i = 0; i < 5; ++i)
            worst[i] = std::max(worst[i], errors[i]);
    }
    // Joldes et al. prove 3 u^2 for sums and 4 u^2 for products with u = 2^-53, that is 0.75 and 1 unit. The
    // quotient and the square root here end with one correction in double, 2^-53 of a rest of 2^-53, and the
    // rest's own error.
    for (int i = 0; i < 5; ++i)
        EXPECT_LE(worst[i], 4) << "operation " << i;
}

TEST(DoubleDouble, OrdersByTheLowPartWhereTheHighPartsAreEqual) {
    const DoubleDouble one(1), more = one + DoubleDouble(0x1p-80), less = one - DoubleDouble(0x1p-80);
    EXPECT_TRUE(less < one && one < more && more > less && less <= one && more >= one);
    EXPECT_FALSE(one < one || more < one || one == more);
    EXPECT_TRUE(one == DoubleDouble(1) && one <= DoubleDouble(1));
}

TEST(DoubleDouble, KeepsInfinityInSumsAndComparisons) {
    const DoubleDouble infinity(std::numeric_limits<double>::infinity());
    EXPECT_TRUE(infinity - DoubleDouble(3) > DoubleDouble(1e300));
    EXPECT_FALSE(isFinite(infinity));
    EXPECT_TRUE(isFinite(DoubleDouble(3)));
}

}  // namespace raytorus::reference
