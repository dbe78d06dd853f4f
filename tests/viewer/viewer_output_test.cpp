// SPDX-License-Identifier: MIT
// What leaves the viewer: events as JSON, files under names that are free, pictures in their place of the
// window.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "support/expect_error.hpp"
#include "support/fresh_seed.hpp"
#include "support/scratch_folder.hpp"
#include "viewer/capture.hpp"
#include "viewer/event_log.hpp"
#include "viewer/frame.hpp"

namespace raytorus::viewer {
namespace {

std::string printed(const std::function<void()>& work) {
    testing::internal::CaptureStdout();
    work();
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout();
}

TEST(EventLog, WritesALineOfJsonForEach) {
    const EventLog log(true);
    const std::string text = printed([&] {
        log.write("empty");
        log.write("full", {{"yes", true},
                           {"number", 1LL << 40},
                           {"real", 0.1},
                           {"vector", std::vector<double>{1.0, -2.5}},
                           {"text", std::string("plain")}});
    });
    EXPECT_EQ(text,
              "{\"event\":\"empty\"}\n"
              "{\"event\":\"full\",\"yes\":true,\"number\":1099511627776,\"real\":0.1,\"vector\":[1.0,-2.5],"
              "\"text\":\"plain\"}\n");
}

TEST(EventLog, EscapesWhateverAFileMayBeCalled) {
    const EventLog log(true);
    const std::string text = "a \"b\"\\c\n\r\t\x01 \xc3\xa4 end";
    const std::string line = printed([&] { log.write("file", {{"name", text}}); });
    ASSERT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
    EXPECT_EQ(nlohmann::json::parse(line)["name"], text);
    // Not UTF-8: one replacement for what cannot be read, the rest as it is.
    for (const std::string bad : {"a\xff", "\xc3(", "\xe2\x82", "\xf0\x28\x8c\xbc"}) {
        const std::string told = printed([&] { log.write("file", {{"name", bad + " end"}}); });
        const std::string name = nlohmann::json::parse(told)["name"];
        EXPECT_NE(name.find("\xef\xbf\xbd"), std::string::npos) << told;
        EXPECT_TRUE(name.ends_with(" end")) << told;
    }
}

TEST(EventLog, IsSilentUnlessAsked) {
    const EventLog log(false);
    EXPECT_EQ(printed([&] { log.write("open", {{"scene", std::string("x")}}); }), "");
}

TEST(FreeName, IsTheFirstNumberThatIsFree) {
    const std::filesystem::path folder = test::scratchFolder();
    EXPECT_EQ(freeName(folder, "shot", ".png"), folder / "shot-001.png");
    test::writeText(folder / "shot-001.png", "");
    test::writeText(folder / "shot-003.png", "");
    EXPECT_EQ(freeName(folder, "shot", ".png"), folder / "shot-002.png");
    test::writeText(folder / "shot-002.png", "");
    EXPECT_EQ(freeName(folder, "shot", ".png"), folder / "shot-004.png");
    EXPECT_EQ(freeName(folder, "shot", ".exr"), folder / "shot-001.exr");
    EXPECT_EQ(freeName(folder, "scene", ".png"), folder / "scene-001.png");
    std::filesystem::create_directory(folder / "scene-001.png");
    EXPECT_EQ(freeName(folder, "scene", ".png"), folder / "scene-002.png");
    for (int i = 1; i < 1000; ++i) {
        test::writeText(folder / fmt::format("many-{:03}.json", i), "");
    }
    EXPECT_EQ(freeName(folder, "many", ".json"), folder / "many-1000.json");
}

VkRect2D placed(VkExtent2D picture, VkExtent2D window) {
    return placeOf(picture, window);
}

TEST(PlaceOf, LeavesAPictureOfTheWindowsSizeUnchanged) {
    const VkRect2D place = placed({333, 77}, {333, 77});
    EXPECT_EQ(place.offset.x, 0);
    EXPECT_EQ(place.offset.y, 0);
    EXPECT_EQ(place.extent.width, 333U);
    EXPECT_EQ(place.extent.height, 77U);
}

TEST(PlaceOf, PutsOtherShapesInTheMiddle) {
    const VkRect2D wide = placed({48, 32}, {480, 480});
    EXPECT_EQ(wide.offset.x, 0);
    EXPECT_EQ(wide.offset.y, 80);
    EXPECT_EQ(wide.extent.width, 480U);
    EXPECT_EQ(wide.extent.height, 320U);
    const VkRect2D tall = placed({10, 40}, {100, 20});
    EXPECT_EQ(tall.extent.width, 5U);
    EXPECT_EQ(tall.extent.height, 20U);
    EXPECT_EQ(tall.offset.x, 47);
    EXPECT_EQ(tall.offset.y, 0);
}

TEST(PlaceOf, IsInsideTouchesTwoSidesAndKeepsTheShape) {
    std::mt19937_64 engine(test::freshSeed());
    const auto side = [&](std::uint32_t most) {
        return std::uniform_int_distribution<std::uint32_t>(1, most)(engine);
    };
    for (int i = 0; i < 2000; ++i) {
        const VkExtent2D picture{side(2000), side(2000)};
        const VkExtent2D window{side(2000), side(2000)};
        const VkRect2D place = placed(picture, window);
        SCOPED_TRACE(
            fmt::format("{} x {} in {} x {}", picture.width, picture.height, window.width, window.height));
        ASSERT_GE(place.offset.x, 0);
        ASSERT_GE(place.offset.y, 0);
        ASSERT_GE(place.extent.width, 1U);
        ASSERT_GE(place.extent.height, 1U);
        const auto right = static_cast<std::uint32_t>(place.offset.x) + place.extent.width;
        const auto bottom = static_cast<std::uint32_t>(place.offset.y) + place.extent.height;
        ASSERT_LE(right, window.width);
        ASSERT_LE(bottom, window.height);
        EXPECT_TRUE(place.extent.width == window.width || place.extent.height == window.height);
        // In the middle, but for an odd pixel.
        EXPECT_LE(window.width - right - static_cast<std::uint32_t>(place.offset.x), 1U);
        EXPECT_LE(window.height - bottom - static_cast<std::uint32_t>(place.offset.y), 1U);
        // The shape, to the rounding of the shorter side; a side of one pixel cannot be shorter.
        const double scale = std::min(static_cast<double>(window.width) / picture.width,
                                      static_cast<double>(window.height) / picture.height);
        EXPECT_LE(std::abs(place.extent.width - std::max(1.0, scale * picture.width)), 0.5 + 1e-9);
        EXPECT_LE(std::abs(place.extent.height - std::max(1.0, scale * picture.height)), 0.5 + 1e-9);
    }
}

}  // namespace
}  // namespace raytorus::viewer
