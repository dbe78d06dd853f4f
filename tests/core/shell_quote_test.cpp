// SPDX-License-Identifier: MIT
// Words for a shell: plain ones as they are, and whatever they hold, the shell reads the same word again.
#include "core/shell_quote.hpp"

#include <gtest/gtest.h>

#include "support/run_program.hpp"

namespace raytorus::test {
namespace {

TEST(ShellQuote, LeavesPlainWordsAlone) {
    for (const char* word :
         {"golden", "out/report-1_2.json", "--folder", "/a/b.c", "1e-4,2", "x=y", "a:b@c+d%"}) {
        EXPECT_EQ(shellQuote(word), word);
    }
}

TEST(ShellQuote, QuotesWhatAShellWouldSeeMoreIn) {
    EXPECT_EQ(shellQuote(""), "''");
    EXPECT_EQ(shellQuote("my goldens; touch PWNED"), "'my goldens; touch PWNED'");
    EXPECT_EQ(shellQuote("it's"), "'it'\\''s'");
    EXPECT_EQ(shellQuote("~"), "'~'");
}

TEST(ShellQuote, HasNothingThatMayNotBeShown) {
    const std::string command = shellQuote("a\x1b[31m\u009b\xff");
    EXPECT_EQ(command, "'a'\"$(printf '\\033')\"'[31m'\"$(printf '\\302\\233')\"''\"$(printf '\\377')\"''");
    EXPECT_EQ(shellOption("--device", "-x y"), " --device='-x y'");
    EXPECT_EQ(shellOption("--device", "x"), " --device x");
}

TEST(ShellQuote, AShellReadsTheSameWordAgain) {
    std::string every;
    for (int c = 1; c < 256; ++c) {
        every += static_cast<char>(c);
    }
    for (const std::string& word :
         {every, std::string("'"), std::string("''"), std::string("$(touch PWNED)`touch PWNED`\\"),
          std::string("a\nb"), std::string("*?[a-z]{a,b}#!"), std::string("\xc3\xa4 \xff"), std::string()}) {
        const ProgramResult result =
            runProgram("/bin/sh", {"-c", "printf '<%s>' " + shellQuote(word) + " end"}, {});
        EXPECT_EQ(result.out, "<" + word + "><end>");
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    }
}

}  // namespace
}  // namespace raytorus::test
