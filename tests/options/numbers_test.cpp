// SPDX-License-Identifier: MIT
// Numbers in options and ray files: which texts are numbers, which, and within which ranges.
#include "options/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/special_floats.hpp"

namespace raytorus::options {
namespace {

TEST(NumberText, FloatIsTheNearest) {
    const std::pair<const char*, float> table[] = {
        {"0", 0.0F},
        {"1", 1.0F},
        {"+1", 1.0F},
        {"-2.5", -2.5F},
        {".5", 0.5F},
        {"5.", 5.0F},
        {"1e3", 1000.0F},
        {"1E-3", 0.001F},
        {"0.1", 0x1.99999ap-4F},
        {"16777217", 16777216.0F},          // half way between two: to even
        {"16777217.0000001", 16777218.0F},  // not half way: no rounding to double in between
        {"3.4028235e38", std::numeric_limits<float>::max()},
        {"1.1754944e-38", std::numeric_limits<float>::min()},
        {"1e-45", std::numeric_limits<float>::denorm_min()},
        {"1e-60", 0.0F},
        {"inf", infinity},
        {"+INF", infinity},
        {"-infinity", -infinity},
    };
    for (const auto& [text, expected] : table) {
        EXPECT_EQ(parseFloat(text), expected) << text;
    }
    EXPECT_TRUE(std::signbit(parseFloat("-0").value()));
    EXPECT_TRUE(std::signbit(parseFloat("-1e-60").value()));
    EXPECT_TRUE(std::isnan(parseFloat("nan").value()));
}

TEST(NumberText, WhatIsNoFloat) {
    for (const char* text : {"", " ", "+", "-", "x", "1x", "1 ", " 1", "1,0", "1e", "0x10", "--1", "1.2.3",
                             "1e39", "-1e39", "1e400", "e5", "."}) {
        EXPECT_EQ(parseFloat(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(NumberText, Size) {
    EXPECT_EQ(parseSize("960x640"), std::pair(960, 640));
    EXPECT_EQ(parseSize("1x1"), std::pair(1, 1));
    EXPECT_EQ(parseSize("16384x16384"), std::pair(16384, 16384));
    for (const char* text : {"", "x", "960", "960x", "x640", "0x1", "1x0", "-1x1", "16385x1", "1x16385",
                             "1x1x1", "1X1", "1 x 1", "1.5x1", "1e2x1", "99999999999x1"}) {
        EXPECT_EQ(parseSize(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(NumberText, SquareGivesItsSide) {
    for (int side = 1; side <= 64; ++side) {
        EXPECT_EQ(parseSquare(std::to_string(side * side)), side);
        EXPECT_EQ(parseSquare(std::to_string(side * side + 1)), std::nullopt);
    }
    for (const char* text : {"", "0", "-1", "-4", "2", "4225", "4.0", "four", "4 ", "99999999999"}) {
        EXPECT_EQ(parseSquare(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(NumberText, Pair) {
    EXPECT_EQ(parsePair("1,0.25"), std::pair(1.0F, 0.25F));
    EXPECT_EQ(parsePair("-1,+2e3"), std::pair(-1.0F, 2000.0F));
    for (const char* text :
         {"", ",", "1", "1,", ",1", "1,2,3", "1, 2", "1;2", "inf,1", "1,nan", "1e39,1", "1,x"}) {
        EXPECT_EQ(parsePair(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(NumberChecks, WholeNumbersAreDecimalDigits) {
    const CLI::Validator check = wholeNumber(1, 1000);
    for (std::string text : {"1", "10", "1000"}) {
        EXPECT_EQ(check(text), "") << text;
    }
    for (std::string text : {"", "0", "1001", "0x2", "010", "-1", "+1", "+-1", "1.0", "1e3", " 1", "1 ",
                             "nan", "inf", "18446744073709551616"}) {
        EXPECT_NE(check(text), "") << text;
    }
    std::string text = "0x2";
    EXPECT_EQ(check(text), "\"0x2\" is no whole number from 1 to 1000");
    const CLI::Validator any = wholeNumber(0, 18446744073709551615U);
    for (std::string edge : {"0", "18446744073709551615"}) {
        EXPECT_EQ(any(edge), "") << edge;
    }
}

TEST(NumberChecks, DecimalNumbersAreFinite) {
    const CLI::Validator check = decimalNumber(-2.5, 1e6);
    for (std::string text : {"-2.5", "0", "1e6", "1E-3", ".5", "5.", "000001"}) {
        EXPECT_EQ(check(text), "") << text;
    }
    for (std::string text : {"", "nan", "-nan", "inf", "-inf", "infinity", "-2.6", "1000001", "0x1", "0x1p3",
                             "+-1", "1,5", "1e", "1e999", "--1", " 1"}) {
        EXPECT_NE(check(text), "") << text;
    }
    std::string text = "nan";
    EXPECT_EQ(check(text), "\"nan\" is no number from -2.5 to 1000000");
}

TEST(NumberChecks, ASignHasNoOther) {
    for (const char* text : {"+-1", "++1", "-+1", "+"}) {
        EXPECT_EQ(parseFloat(text), std::nullopt) << text;
    }
    EXPECT_EQ(parseFloat("+1"), 1.0F);
    EXPECT_EQ(parseSize("+-1x2"), std::nullopt);
}

}  // namespace
}  // namespace raytorus::options
