// SPDX-License-Identifier: MIT
// Quantiles of many values, from bins a sixteenth wide.
#include "judge/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raytorus::judge {
namespace {

Histogram filled(double from, double step, int count) {
    Histogram histogram;
    for (int i = 0; i < count; ++i) {
        histogram.add(from + step * i);
    }
    return histogram;
}

TEST(Histogram, IsZeroWhenEmpty) {
    const Histogram histogram;
    EXPECT_EQ(histogram.count(), 0U);
    EXPECT_EQ(histogram.max(), 0.0);
    EXPECT_EQ(histogram.quantile(0.99), 0.0);
    EXPECT_TRUE(histogram.bins().empty());
}

TEST(Histogram, QuantilesAreAtMostASixteenthTooLarge) {
    const Histogram histogram = filled(1e-8, 1e-10, 10000);
    for (const double part : {0.1, 0.5, 0.9, 0.99}) {
        const double exact = 1e-8 + 1e-10 * (part * 10000 - 1);
        EXPECT_GE(histogram.quantile(part), exact * (1 - 1e-12)) << part;
        EXPECT_LE(histogram.quantile(part), exact * 17 / 16) << part;
    }
}

TEST(Histogram, TheLastQuantileIsTheMaximum) {
    const Histogram histogram = filled(1.0, 0.001, 501);
    EXPECT_DOUBLE_EQ(histogram.max(), 1.5);
    EXPECT_DOUBLE_EQ(histogram.quantile(1.0), 1.5);
}

TEST(Histogram, ZerosAreCounted) {
    Histogram histogram = filled(0.0, 0.0, 99);
    histogram.add(1.0);
    EXPECT_LT(histogram.quantile(0.99), 1e-19);
    EXPECT_EQ(histogram.quantile(0.999), 1.0);
    ASSERT_EQ(histogram.bins().size(), 2U);
    EXPECT_EQ(histogram.bins()[0].count, 99U);
}

TEST(Histogram, WhatIsNoNumberIsTheWorst) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0}) {
        Histogram histogram = filled(1.0, 0.0, 3);
        histogram.add(bad);
        EXPECT_TRUE(std::isinf(histogram.max())) << bad;
        EXPECT_GT(histogram.quantile(1.0), 1e18) << bad;
        EXPECT_LE(histogram.quantile(0.75), 17.0 / 16) << bad;
    }
}

TEST(Histogram, MergingIsAddingUp) {
    Histogram merged = filled(1e-8, 1e-10, 700);
    merged.merge(filled(1e-8 + 700e-10, 1e-10, 300));
    const Histogram whole = filled(1e-8, 1e-10, 1000);
    EXPECT_EQ(merged.count(), whole.count());
    EXPECT_DOUBLE_EQ(merged.max(), whole.max());
    for (const double part : {0.01, 0.5, 0.99}) {
        EXPECT_EQ(merged.quantile(part), whole.quantile(part));
    }
}

}  // namespace
}  // namespace raytorus::judge
