// SPDX-License-Identifier: MIT
// Rounded: what float32 makes of an expression lies within its error, and the error is no wild guess.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/random.hpp"
#include "support/fresh_seed.hpp"
#include "truth/rounded.hpp"

namespace raytorus::truth {
namespace {

using reference::Random;

// A float and its exact counterpart, which carries the bound.
struct Pair {
    float asFloat;
    Rounded exact;
};

Pair drawn(Random& random) {
    const auto x = static_cast<float>(random.sign() * std::exp2(random.uniform(-6.0, 6.0)));
    return {x, Rounded(static_cast<double>(x))};
}

// One random operation of two values, by both.
Pair combined(Random& random, const Pair& a, const Pair& b) {
    switch (random.below(5)) {
        case 0:
            return {a.asFloat + b.asFloat, a.exact + b.exact};
        case 1:
            return {a.asFloat - b.asFloat, a.exact - b.exact};
        case 2:
            return {a.asFloat * b.asFloat, a.exact * b.exact};
        case 3:
            return {a.asFloat / b.asFloat, a.exact / b.exact};
        default: {
            const float positive = std::abs(b.asFloat);
            return {std::sqrt(positive), squareRoot(Rounded(static_cast<double>(positive)))};
        }
    }
}

TEST(TruthRounded, BoundsWhatFloatsDo) {
    constexpr int trials = 200000;
    double largestRatio = 0.0;
    for (std::uint64_t i = 0; i < trials; ++i) {
        Random random(test::freshSeed(), 2100, i);
        Pair value = drawn(random);
        for (int step = 0; step < 4; ++step) {
            value = combined(random, value, drawn(random));
        }
        const double off = std::abs(static_cast<double>(value.asFloat) - value.exact.value);
        // The value itself is a double's: some roundings of 2^-53.
        ASSERT_LE(off, value.exact.error * (1.0 + 1e-6)) << "trial " << i;
        if (value.exact.error > 0.0) {
            largestRatio = std::max(largestRatio, off / value.exact.error);
        }
    }
    EXPECT_GT(largestRatio, 0.8) << "bounds that nothing comes near";
}

TEST(TruthRounded, IsExactWhereFloatsAre) {
    const Rounded third(1.0F / 3.0F);
    EXPECT_EQ((third * Rounded(0.25)).error, 0.0);
    EXPECT_EQ((third / Rounded(2.0)).error, 0.0);
    EXPECT_EQ((third + Rounded(0.0)).error, 0.0);
    EXPECT_EQ((third - Rounded(0.3F)).error, 0.0);  // Sterbenz
    EXPECT_EQ((third + Rounded(0.3F)).error, 0x1p-25);
}

TEST(TruthRounded, DividesByWhatMayBeZeroWithoutBound) {
    EXPECT_TRUE(std::isinf((Rounded(1.0) / Rounded(0.1, 0.2)).error));
}

TEST(TruthRounded, LosesItsErrorBelowABound) {
    EXPECT_EQ(atLeast(Rounded(-1.0, 0.5), 0.0).error, 0.0);
    EXPECT_EQ(atLeast(Rounded(-0.25, 0.5), 0.0).error, 0.5);
    EXPECT_EQ(atLeast(Rounded(-0.25, 0.5), 0.0).value, 0.0);
}

}  // namespace
}  // namespace raytorus::truth
