// SPDX-License-Identifier: MIT
// The last sentence says every kind of wrong answer in plain words, and the numbers it tells are told as they
// are.
#include <gtest/gtest.h>

#include <limits>

#include "explain/conclusion.hpp"
#include "explain/number_text.hpp"

namespace raytorus::test {
namespace {

using explain::Explanation;
using explain::Quad;

// Four hits of a ring, all found by everyone.
Explanation rightAnswer() {
    Explanation e;
    e.torus = {1.0F, 0.25F};
    e.hits.resize(4);
    e.closedForm.resize(4);
    e.library = {true, 4, 4, 0.31, 2e-8};
    e.closedForms = {true, 4, 4, 12.3, 1e-6};
    e.clearance = e.startClearance = e.stopClearance = 0.5;
    return e;
}

TEST(ExplainConclusion, Right) {
    EXPECT_EQ(explain::conclusionOf(rightAnswer()),
              "the library is right: 4 hits, t off by at most 0.31 ulp, positions by 2e-08 (R + r); the "
              "closed form "
              "finds 4 roots, t off by at most 12 ulp, positions by 1e-06 (R + r)");
    EXPECT_TRUE(explain::isRight(rightAnswer()));
}

TEST(ExplainConclusion, WrongCounts) {
    struct Row {
        int expected, found;
        const char* words;
    };
    for (const Row& row : {Row{4, 2, "misses 2 of 4 "}, Row{2, 0, "misses both "}, Row{4, 0, "misses all 4 "},
                           Row{1, 0, "misses the "}, Row{0, 1, "invents 1 "}, Row{2, 4, "invents 2 "}}) {
        Explanation e = rightAnswer();
        e.library.expected = e.closedForms.expected = row.expected;
        e.library.found = e.closedForms.found = row.found;
        const std::string sentence = explain::conclusionOf(e);
        EXPECT_TRUE(sentence.starts_with(std::string("the library ") + row.words + "hit")) << sentence;
        EXPECT_NE(sentence.find(std::string("; the closed form ") + row.words + "root"), std::string::npos)
            << sentence;
        EXPECT_FALSE(explain::isRight(e));
    }
}

TEST(ExplainConclusion, OtherFaults) {
    Explanation e = rightAnswer();
    e.agree = false;
    EXPECT_TRUE(
        explain::conclusionOf(e).starts_with("torusIntersect, torusOccluded and torusIntersectAll disagree"));
    EXPECT_FALSE(explain::isRight(e));
    e = rightAnswer();
    e.library.position = 0.01;  // of R + r = 1.25: more than 0.01 r
    EXPECT_TRUE(explain::conclusionOf(e).starts_with("the library is wrong: of its 4 hits, t off by"));
    EXPECT_FALSE(explain::isRight(e));
    e.library.position = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(explain::isRight(e));
    e = rightAnswer();
    e.faults = {"r = 0 is not positive"};
    e.library = {true, 0, 4, 0.0, 0.0};
    EXPECT_EQ(explain::conclusionOf(e), "the library is wrong: a hit for bad input");
}

// Where an end of the ray lies on the surface the contract leaves that hit open, and no other.
TEST(ExplainConclusion, AHitAtAnEndMayGoEitherWay) {
    Explanation e = rightAnswer();
    e.startClearance = 1e-7;
    e.library.found = 3;
    EXPECT_TRUE(explain::isRight(e));
    EXPECT_TRUE(
        explain::conclusionOf(e).starts_with("the library keeps its contract: at an end of the ray, where a "
                                             "hit may go either way, answers differ"));
    e.agree = false;
    EXPECT_TRUE(explain::isRight(e));
    e.library.found = 2;
    EXPECT_FALSE(explain::isRight(e));
    e.stopClearance = 1e-7;
    EXPECT_TRUE(explain::isRight(e));
    e.startClearance = e.stopClearance = 1e-3;
    EXPECT_FALSE(explain::isRight(e));
}

TEST(ExplainConclusion, Tangents) {
    Explanation e = rightAnswer();
    e.clearance = 2.1e-5;
    EXPECT_TRUE(explain::conclusionOf(e).ends_with(": the line passes within 2.1e-05 r of a tangent"));
    e.clearance = 0.0;
    EXPECT_TRUE(explain::conclusionOf(e).ends_with(": the line is a tangent"));
}

TEST(ExplainMatch, KeepsTheOrderAndTakesTheNearest) {
    using Places = std::vector<std::size_t>;
    EXPECT_EQ(explain::matched({}, {1, 2}), Places{});
    EXPECT_EQ(explain::matched({}, {}), Places{});
    EXPECT_EQ(explain::matched({1, 2}, {1, 2}), (Places{0, 1}));
    EXPECT_EQ(explain::matched({3.1, 4.1}, {1, 2, 3, 4}), (Places{2, 3}));
    EXPECT_EQ(explain::matched({0.9, 4.1}, {1, 2, 3, 4}), (Places{0, 3}));
    EXPECT_EQ(explain::matched({2, 2}, {1, 2, 2, 9}), (Places{1, 2}));
    EXPECT_EQ(explain::matched({100}, {1, 2, 3}), Places{2});
}

TEST(ExplainNumbers, Ulps) {
    EXPECT_EQ(explain::floatUlp(1.0), 0x1p-23);
    EXPECT_EQ(explain::floatUlp(1.99), 0x1p-23);
    EXPECT_EQ(explain::floatUlp(0.999), 0x1p-24);
    EXPECT_EQ(explain::floatUlp(0.0), 0x1p-149);
    EXPECT_EQ(explain::floatUlp(1e-40), 0x1p-149);
    EXPECT_EQ(explain::ulpError(1.0F, Quad(1)), 0.0);
    EXPECT_EQ(explain::ulpError(1.0F, Quad(1) + Quad(0x1p-24)), 0.5);
    EXPECT_EQ(explain::ulpError(-3.0F, Quad(-3) - Quad(0x1p-21)), 2.0);
    EXPECT_EQ(explain::ulpError(1e-20F, Quad(0)), std::numeric_limits<double>::infinity());
    EXPECT_EQ(explain::ulpError(std::numeric_limits<float>::quiet_NaN(), Quad(1)),
              std::numeric_limits<double>::infinity());
}

TEST(ExplainNumbers, Texts) {
    EXPECT_EQ(explain::decimal(Quad(0.1F)), "0.100000001490116119384765625");
    EXPECT_EQ(explain::decimal(Quad(1) / 3), "0.333333333333333333333333333333333");
    EXPECT_EQ(explain::decimal(-Quad(0)), "0");
    EXPECT_EQ(explain::decimal(0.1F), "0.1");
    EXPECT_EQ(explain::hexadecimal(-3.0F), "-0x1.8p+1");
    EXPECT_EQ(explain::hexadecimal(std::numeric_limits<float>::infinity()), "inf");
    EXPECT_EQ(explain::roughly(3.7e-29), "0");
    EXPECT_EQ(explain::counted(1, "hit"), "1 hit");
    EXPECT_EQ(explain::counted(0, "hit"), "0 hits");
}

}  // namespace
}  // namespace raytorus::test
