// SPDX-License-Identifier: MIT
// Which texts are numbers where a command line wants one.
#include "options/number_checks.hpp"

#include <gtest/gtest.h>

#include "options/number_text.hpp"

namespace raytorus::options {
namespace {

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
