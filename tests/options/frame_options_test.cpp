// SPDX-License-Identifier: MIT
// From --time, --frames and --fps to moments and files.
#include "options/frame_options.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace raytorus::options {
namespace {

TEST(FrameOptions, OnePictureIsTheFileItself) {
    const std::vector<SequenceFrame> frames = framesOf({}, "a-##.png");
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].output, "a-##.png");
    EXPECT_EQ(frames[0].seconds, 0.0);
    EXPECT_FALSE(FrameOptions{}.moves());
    EXPECT_FALSE(FrameOptions{}.sequence());
    EXPECT_EQ(framesOf({"-2.5", "", ""}, "a.png")[0].seconds, -2.5);
    EXPECT_EQ(framesOf({"1e3", "", ""}, "a.png")[0].seconds, 1000.0);
    EXPECT_TRUE((FrameOptions{"0", "", ""}.moves()));
    EXPECT_TRUE((FrameOptions{"", "1", "1"}.sequence()));
}

TEST(FrameOptions, NumbersStandForTheRunOfHashes) {
    const auto names = [](const std::string& count, const std::string& output) {
        std::string all;
        for (const SequenceFrame& frame : framesOf({"", count, "24"}, output)) {
            all += frame.output + " ";
        }
        return all;
    };
    EXPECT_EQ(names("3", "frame-####.png"), "frame-0000.png frame-0001.png frame-0002.png ");
    EXPECT_EQ(names("1", "#.exr"), "0.exr ");
    EXPECT_EQ(names("10", "a#b.png"),
              "a0b.png a1b.png a2b.png a3b.png a4b.png a5b.png a6b.png a7b.png a8b.png a9b.png ");
    EXPECT_EQ(names("2", "##/x ##{}.png"), "##/x 00{}.png ##/x 01{}.png ");
    EXPECT_EQ(framesOf({"", "100", "24"}, "##.png").back().output, "99.png");
    EXPECT_EQ(framesOf({"", "1000000", "24"}, "######.png").back().output, "999999.png");
}

TEST(FrameOptions, MomentsAreThoseOfTheFrames) {
    const std::vector<SequenceFrame> frames = framesOf({"0.5", "97", "24"}, "##.png");
    for (std::size_t k = 0; k < frames.size(); ++k) {
        EXPECT_EQ(frames[k].seconds, 0.5 + static_cast<double>(k) / 24.0);
    }
    EXPECT_EQ(framesOf({"", "3", "29.97"}, "#.png")[2].seconds, 2 / 29.97);
    EXPECT_EQ(framesOf({"", "3", "0.25"}, "#.png")[2].seconds, 8.0);
}

void expectRefused(const FrameOptions& options, const std::string& output,
                   std::initializer_list<std::string> words) {
    test::expectError([&] { std::ignore = framesOf(options, output); }, ExitCode::Usage, words);
}

TEST(FrameOptions, NumbersThatAreNone) {
    for (const char* text : {"x", "1s", "inf", "nan", "-inf", "1e999", " 1", "+1", "0x1", "1,5"}) {
        expectRefused({text, "", ""}, "a.png",
                      {"--time", "number of seconds", std::string("\"") + text + "\""});
        expectRefused({"", "2", text}, "#.png", {"--fps", "positive", std::string("\"") + text + "\""});
        expectRefused({"", text, "24"}, "#.png",
                      {"--frames", "from 1 to 1000000", std::string("\"") + text + "\""});
    }
    for (const char* text : {"0", "-1", "-0"}) {
        expectRefused({"", "2", text}, "#.png", {"--fps", "positive", std::string("\"") + text + "\""});
        expectRefused({"", text, "24"}, "#.png", {"--frames", std::string("\"") + text + "\""});
    }
    for (const char* text : {"1000001", "99999999999999999999", "2.5", "1e3"}) {
        expectRefused({"", text, "24"}, "########.png", {"--frames", std::string("\"") + text + "\""});
    }
}

TEST(FrameOptions, Contradictions) {
    expectRefused({"", "3", ""}, "#.png", {"--frames needs --fps"});
    expectRefused({"", "", "24"}, "#.png", {"--fps needs --frames"});
    expectRefused({"", "3", "24"}, "a.png", {"run of #", "frame-####.png", "\"a.png\""});
    expectRefused({"", "3", "24"}, "a#/b.png", {"run of #", "\"a#/b.png\""});
    expectRefused({"", "3", "24"}, "a#b##.png", {"one run", "\"a#b##.png\""});
    expectRefused({"", "11", "24"}, "a#.png", {"\"a#.png\"", "no room for the number 10"});
    expectRefused({"", "101", "24"}, "a##.png", {"no room for the number 100"});
    expectRefused({"1e308", "3", "1e-308"}, "#.png", {"--time and --fps", "frame 2"});
}

}  // namespace
}  // namespace raytorus::options
