// SPDX-License-Identifier: MIT
#include "compile/directives.hpp"

#include <gtest/gtest.h>

namespace raytorus::compile {
namespace {

std::string written(std::string_view text) {
    std::string all;
    for (const Directive& directive : findDirectives(text)) {
        all += std::to_string(directive.line) + ":" + directive.keyword + "(" + directive.rest + ")";
    }
    return all;
}

TEST(Directives, AreFoundOutsideOfCommentsOnly) {
    EXPECT_EQ(written(""), "");
    EXPECT_EQ(written("#if A\nx # y\n  #  endif  "), "1:if(A)3:endif()");
    EXPECT_EQ(written("// #if\n/* #if\n#if */ #if B // c\n#"), "3:if(B)4:()");
    EXPECT_EQ(written("#define A \\\n b\n#undef A"), "1:define(A  b)3:undef(A)");
    EXPECT_EQ(written("#define A \\\r\n b\r\n#undef A\r\n"), "1:define(A  b)3:undef(A)");
    EXPECT_EQ(written("// a \\\n#if\n#else"), "3:else()");
    EXPECT_EQ(written("#if/* a\nb */1\n#endif"), "1:if(1)3:endif()");
    EXPECT_EQ(written("/* #if"), "");
    EXPECT_EQ(written(std::string(1'000'000, ' ') + "\n" + std::string(1'000'000, ' ') + "#if"), "2:if()");
    EXPECT_EQ(written("#include \"a.glsl\"\n"), "1:include(\"a.glsl\")");
}

int unclosedLine(std::string_view text) {
    const auto open = unclosedConditional(findDirectives(text));
    return open ? open->line : 0;
}

TEST(Directives, InnermostOpenConditional) {
    EXPECT_EQ(unclosedLine("#if 1\n#elif 2\n#else\n#endif\n"), 0);
    EXPECT_EQ(unclosedLine("\n#if 1\n#else\n"), 2);
    EXPECT_EQ(unclosedLine("#ifdef A\n#ifndef B\n#endif\n"), 1);
    EXPECT_EQ(unclosedLine("#ifdef A\n#ifndef B\n"), 2);
    EXPECT_EQ(unclosedLine("#endif\n#if 1\n"), 2);
}

TEST(Directives, IncludeGuards) {
    const auto guarded = [](std::string_view text) { return hasIncludeGuard(findDirectives(text)); };
    EXPECT_TRUE(guarded("// a\n#ifndef A\n#define A\n#if 1\n#endif\nint a;\n#endif // A\n"));
    EXPECT_TRUE(guarded("#if !defined(A_1)\n#define A_1 1\n#endif\n"));
    EXPECT_TRUE(guarded("#if ! defined A\n#define A\n#endif\n"));
    EXPECT_FALSE(guarded(""));
    EXPECT_FALSE(guarded("#ifdef A\n#define A\n#endif\n"));
    EXPECT_FALSE(guarded("#ifndef A\n#define B\n#endif\n"));
    EXPECT_FALSE(guarded("#ifndef A\n#define A2\n#endif\n"));
    EXPECT_FALSE(guarded("#ifndef A\n#define A\n"));
    EXPECT_FALSE(guarded("#ifndef A\n#define A\n#endif\n#include \"a\"\n"));
    EXPECT_FALSE(guarded("#if !defined(A) || 1\n#define A\n#endif\n"));
    EXPECT_FALSE(guarded("#ifndef A\n#include \"a\"\n#define A\n#endif\n"));
}

}  // namespace
}  // namespace raytorus::compile
