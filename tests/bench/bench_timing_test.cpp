// SPDX-License-Identifier: MIT
// Turns are taken fairly, a run that answers otherwise is noticed, and ratios are what they are said to be.
#include <gtest/gtest.h>

#include <string>

#include "bench/timing.hpp"

namespace raytorus::bench {
namespace {

// A contestant that notes its letter at every run.
std::function<Shot()> noting(std::string& log, char letter) {
    return [&log, letter] {
        log += letter;
        return Shot{1.0, 1.0, 7, true};
    };
}

TEST(BenchTurns, BeginEachRoundWithTheNext) {
    std::string log;
    const auto series = takeTurns({noting(log, 'a'), noting(log, 'b'), noting(log, 'c')}, 4);
    EXPECT_EQ(log, "abcabcbcacababc") << "once untimed, then in turns";
    for (const Series& its : series) {
        EXPECT_EQ(its.nanoseconds.size(), 4U);
        EXPECT_TRUE(its.checksumHeld);
    }
}

TEST(BenchTurns, CountNanosecondsARay) {
    const auto series = takeTurns({[] { return Shot{4.0, 2e9, 7, true}; }}, 1);
    EXPECT_DOUBLE_EQ(series[0].nanoseconds.front(), 2.0);
}

TEST(BenchTurns, NoticeARunThatAnswersOtherwise) {
    unsigned runs = 0;
    const std::function<Shot()> changing = [&runs] {
        ++runs;
        return Shot{1.0, 1.0, runs == 3 ? 8U : 7U, true};
    };
    const std::function<Shot()> steady = [] { return Shot{1.0, 1.0, 7, true}; };
    const auto series = takeTurns({changing, steady}, 4);
    EXPECT_FALSE(series[0].checksumHeld);
    EXPECT_TRUE(series[1].checksumHeld);
}

TEST(BenchTurns, NoticeLayersThatDiffer) {
    for (const unsigned bad : {1U, 3U}) {
        unsigned runs = 0;
        const auto series = takeTurns({[&] {
                                          ++runs;
                                          return Shot{1.0, 1.0, 7, runs != bad};
                                      }},
                                      3);
        EXPECT_FALSE(series[0].checksumHeld) << bad;
    }
}

// Rounds of a contestant.
Series rounds(std::vector<double> nanoseconds) {
    return {std::move(nanoseconds), true};
}

TEST(BenchTimes, AreNetOfTheEmptyOneRoundByRound) {
    const Series empty = rounds({1, 1, 2, 1, 1});
    const Series ours = rounds({5, 6, 6, 5, 9});
    const Series its = rounds({3, 3, 4, 5, 3});
    const Times times = timesOf(its, ours, &empty);
    EXPECT_DOUBLE_EQ(times.minimum, 3);
    EXPECT_DOUBLE_EQ(times.median, 3);
    EXPECT_DOUBLE_EQ(times.netMinimum, 2);
    EXPECT_DOUBLE_EQ(times.ratio, 4.0 / 2.0);
    // 4/2, 5/2, 4/2, 4/4, 8/2: sorted 1 2 2 2.5 4.
    EXPECT_DOUBLE_EQ(times.lowerQuartile, 2);
    EXPECT_DOUBLE_EQ(times.middleRatio, 2);
    EXPECT_DOUBLE_EQ(times.upperQuartile, 2.5);
}

TEST(BenchTimes, AreGrossWithoutAnEmptyOne) {
    const Times times = timesOf(rounds({2, 2, 3, 4}), rounds({1, 1, 1, 1}), nullptr);
    EXPECT_DOUBLE_EQ(times.minimum, 2);
    EXPECT_DOUBLE_EQ(times.median, 2.5);
    EXPECT_DOUBLE_EQ(times.netMinimum, 2);
    EXPECT_DOUBLE_EQ(times.ratio, 0.5);
}

TEST(BenchTimes, HaveNoRatioWhereNothingIsLeft) {
    const Series empty = rounds({2, 2});
    const Times times = timesOf(rounds({2, 1}), rounds({4, 4}), &empty);
    EXPECT_EQ(times.ratio, 0.0);
    EXPECT_EQ(times.middleRatio, 0.0);
}

// As they have been seen: a run of 42 ns that a processor's clock gave as 2.4.
TEST(BenchMinimum, IsConfirmedByAnotherRun) {
    EXPECT_DOUBLE_EQ(confirmedMinimum({42.5, 2.4, 44.0, 41.0, 60.0}), 41.0);
    EXPECT_DOUBLE_EQ(confirmedMinimum({1.0, 2.4, 41.0, 41.5, 43.0}), 41.0) << "two such runs";
    EXPECT_DOUBLE_EQ(confirmedMinimum({5.0, 5.4, 9.0}), 5.0);
    EXPECT_DOUBLE_EQ(confirmedMinimum({1.0, 2.0, 4.0}), 2.0) << "the median";
    EXPECT_DOUBLE_EQ(confirmedMinimum({5.0}), 5.0);
}

// The run that was too fast moves neither the ratio nor what is taken off.
TEST(BenchTimes, AreNotThoseOfASingleRun) {
    const Times times = timesOf(rounds({1, 21, 21}), rounds({41, 41, 2}), nullptr);
    EXPECT_DOUBLE_EQ(times.ratio, 41.0 / 21.0);
    const Series empty = rounds({0.1, 1, 1});
    EXPECT_DOUBLE_EQ(timesOf(rounds({11, 11, 11}), rounds({6, 6, 6}), &empty).ratio, 0.5);
}

TEST(BenchQuantile, LiesLinearlyBetweenTwoValues) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.0), 1);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1.0), 4);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile({5}, 0.75), 5);
    EXPECT_EQ(quantile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace raytorus::bench
