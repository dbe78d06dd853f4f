// SPDX-License-Identifier: MIT
// What is shown of texts that nobody has looked at.
#include "core/console.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "core/markup.hpp"

namespace raytorus {
namespace {

using namespace std::string_literals;

TEST(Console, ShowsTextAsItIs) {
    for (const std::string text :
         {"", "plain, with \"quotes\" and \\", "two\nlines\tand a tab", "π 日本 é 🍩 ½"}) {
        EXPECT_EQ(printable(text), text);
    }
}

TEST(Console, EscapesWhatATerminalObeys) {
    EXPECT_EQ(printable("a\x1b[31mb"), "a\\u001b[31mb");
    EXPECT_EQ(printable("nul\0, bell\a, back\b, return\r"s),
              "nul\\u0000, bell\\u0007, back\\u0008, return\\u000d");
    EXPECT_EQ(printable("\x7f"), "\\u007f");
    EXPECT_EQ(printable("\u009b31m"), "\\u009b31m");
    EXPECT_EQ(printable("\u202e\u2066\u200f\u061c"), "\\u202e\\u2066\\u200f\\u061c")
        << "turn the direction of text";
    EXPECT_EQ(printable("\uffff\ufdd0\ufeff"), "\\uffff\\ufdd0\\ufeff");
    EXPECT_EQ(printable("\U0010ffff"), "\\U0010ffff");
    EXPECT_EQ(printable("\u2028"), "\\u2028");
}

TEST(Console, KnowsUtf8) {
    for (const std::string text : {"", "a\nb", "π 日本 é 🍩 ½", "\u009b\uffff", "\U0010ffff"}) {
        EXPECT_TRUE(isUtf8(text)) << text;
    }
    for (const std::string text :
         {"\xff", "a\xc3", "\xc3(", "\xe2\x82(", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "caf\xe9"}) {
        EXPECT_FALSE(isUtf8(text)) << printable(text);
    }
}

TEST(Console, EscapesWhatIsNoUtf8) {
    EXPECT_EQ(printable("\xff"), "\\xff");
    EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
    EXPECT_EQ(printable("\xc3(\x80"), "\\xc3(\\x80");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "two bytes for one";
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last";
    EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");
}

TEST(Console, CutsAnExcerpt) {
    EXPECT_EQ(excerpt("short"), "short");
    EXPECT_EQ(excerpt("a\nb\tc"), "a\\u000ab\\u0009c") << "one line";
    EXPECT_EQ(excerpt(std::string(200, 'x')), std::string(200, 'x'));
    EXPECT_EQ(excerpt(std::string(201, 'x')), std::string(200, 'x') + "...");
    EXPECT_EQ(excerpt("日本", 5), "日...") << "no half characters";
    EXPECT_EQ(excerpt(std::string(10'000'000, '\x1b'), 12), "\\u001b\\u001b...");
}

TEST(Console, EscapesWhatIsMarkup) {
    EXPECT_EQ(escapeHtml("<a href=\"x\">it's & more</a>"),
              "&lt;a href=&quot;x&quot;&gt;it&#39;s &amp; more&lt;/a&gt;");
    EXPECT_EQ(escapeHtml("\x1b\u009b\uffff\xff\n\tend"), "\\u001b\\u009b\\uffff\\xff\n\tend");
}

TEST(Console, WritesJsonThatCanBeShown) {
    const std::string words = "\x1b\x7f\u009b\u2028\ufeff\uffff\U0001fffe\U0010ffff \"\\ \n π 🍩"s;
    const nlohmann::ordered_json json = {{words, {words, 1}}, {"nul", "\0"s}};
    for (const int indent : {-1, 0, 2}) {
        const std::string text = dumpJson(json, indent);
        EXPECT_EQ(printable(text), text) << "nothing is left to be escaped";
        EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
        EXPECT_NE(
            text.find(
                "\\u001b\\u007f\\u009b\\u2028\\ufeff\\uffff\\ud83f\\udffe\\udbff\\udfff \\\"\\\\ \\n π 🍩"),
            std::string::npos)
            << text;
    }
    EXPECT_EQ(dumpJson({"\xff\xed\xa0\x80", "caf\xe9"}, -1), "[\"\ufffd\ufffd\ufffd\ufffd\",\"caf\ufffd\"]");
}

}  // namespace
}  // namespace raytorus
