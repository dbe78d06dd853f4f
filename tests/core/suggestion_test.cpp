// SPDX-License-Identifier: MIT
#include "core/suggestion.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace raytorus {
namespace {

const std::vector<std::string> known = {"sky", "gold", "silver"};

TEST(Suggestion, IsTheNearestWordOfWhichTwoThirdsAreRight) {
    EXPECT_EQ(suggestion("skye", known), "; did you mean sky?");
    EXPECT_EQ(suggestion("glod", known), "; did you mean gold?");
    EXPECT_EQ(suggestion("sliver", known), "; did you mean silver?");
}

TEST(Suggestion, IsNoneForAnotherWord) {
    EXPECT_EQ(suggestion("ski-ing", known), "");
    EXPECT_EQ(suggestion("iron", known), "");
    EXPECT_EQ(suggestion("try", known), "");
    EXPECT_EQ(suggestion("", known), "");
    EXPECT_EQ(suggestion("gold", {}), "");
}

TEST(Suggestion, IsTheFirstOfThoseThatAreEquallyNear) {
    const std::vector<std::string> twins = {"ring", "king"};
    EXPECT_EQ(suggestion("wing", twins), "; did you mean ring?");
}

}  // namespace
}  // namespace raytorus
