// SPDX-License-Identifier: MIT
// The size of moving pictures: within the time there is, learned from drawings, never nothing.
#include <gtest/gtest.h>

#include "viewer/resolution.hpp"

namespace raytorus::viewer {
namespace {

double pixelsOf(VkExtent2D extent) {
    return static_cast<double>(extent.width) * extent.height;
}

// As if each pixel took so long, and each drawing the constant part besides.
void draw(Resolution& resolution, VkExtent2D extent, double secondsPerPixel) {
    resolution.learn(extent, 1, 0.001 + secondsPerPixel * pixelsOf(extent));
}

TEST(Resolution, IsTheWindowsUntilSomethingIsKnown) {
    const Resolution resolution;
    const VkExtent2D extent = resolution.movingExtent({801, 603});
    EXPECT_EQ(extent.width, 801U);
    EXPECT_EQ(extent.height, 603U);
}

TEST(Resolution, StaysWithinTheBudget) {
    for (const double cost : {1e-9, 1e-8, 3e-8, 1e-7, 5e-7, 1e-6}) {
        for (const VkExtent2D window : {VkExtent2D{800, 600}, VkExtent2D{1919, 1081}, VkExtent2D{64, 48}}) {
            Resolution resolution;
            draw(resolution, window, cost);
            const VkExtent2D moving = resolution.movingExtent(window);
            const bool smallest = moving.width <= window.width / 8 + 8;
            EXPECT_TRUE(cost * pixelsOf(moving) <= Resolution::movingSeconds * (1.0 + 1e-12) || smallest)
                << cost << ": " << moving.width << " x " << moving.height;
            if (cost * pixelsOf(window) <= Resolution::movingSeconds) {
                EXPECT_EQ(moving.width, window.width);
                EXPECT_EQ(moving.height, window.height);
            } else {
                EXPECT_EQ(moving.width % 8, 0U);
                EXPECT_EQ(moving.height % 8, 0U);
                // No more is given away than rounding takes.
                EXPECT_GT(
                    cost * static_cast<double>(moving.width + 8) * static_cast<double>(moving.height + 8),
                    Resolution::movingSeconds * (1.0 - 1e-12));
            }
        }
    }
}

TEST(Resolution, IsNeverNothing) {
    for (const VkExtent2D window :
         {VkExtent2D{1, 1}, VkExtent2D{1, 900}, VkExtent2D{7, 3}, VkExtent2D{4000, 1}}) {
        for (const double cost : {0.0, 1e-6, 1.0, 1e9}) {
            Resolution resolution;
            draw(resolution, window, cost);
            const VkExtent2D moving = resolution.movingExtent(window);
            EXPECT_GE(moving.width, 1U);
            EXPECT_GE(moving.height, 1U);
            EXPECT_LE(moving.width, window.width);
            EXPECT_LE(moving.height, window.height);
        }
    }
    Resolution resolution;
    resolution.learn({0, 0}, 1, 5.0);
    resolution.learn({100, 100}, 0, 5.0);
    EXPECT_EQ(resolution.movingExtent({100, 100}).width, 100U);
}

TEST(Resolution, LearnsBothWays) {
    constexpr VkExtent2D window{800, 600};
    Resolution resolution;
    draw(resolution, window, 1e-8);
    EXPECT_EQ(resolution.movingExtent(window).width, 800U);
    // One slow drawing is no reason: a pipeline may have been compiled.
    resolution.learn(window, 1, 0.05);
    EXPECT_GT(resolution.movingExtent(window).width, 500U);
    for (int i = 0; i < 30; ++i) {
        draw(resolution, resolution.movingExtent(window), 4e-7);
    }
    const VkExtent2D slow = resolution.movingExtent(window);
    EXPECT_LE(4e-7 * pixelsOf(slow), 1.01 * Resolution::movingSeconds);
    EXPECT_LT(slow.width, 300U);
    for (int i = 0; i < 30; ++i) {
        draw(resolution, resolution.movingExtent(window), 1e-8);
    }
    EXPECT_EQ(resolution.movingExtent(window).width, 800U);
}

TEST(Resolution, LeavesTimeForShowing) {
    const VkExtent2D window{800, 600};
    Resolution resolution;
    resolution.learn(window, 1, 0.001 + 0.016);  // the whole picture just fits
    EXPECT_EQ(pixelsOf(resolution.movingExtent(window)), pixelsOf(window));
    for (int i = 0; i < 50; ++i) {
        resolution.learnShowing(0.020);
    }
    const double slower = pixelsOf(resolution.movingExtent(window));
    EXPECT_LE(slower / pixelsOf(window) * 0.016 + 0.020, Resolution::frameSeconds + 1e-9);
    EXPECT_GT(slower, 0.4 * pixelsOf(window));  // of the half that there is time for
    for (int i = 0; i < 50; ++i) {
        resolution.learnShowing(10.0);  // hopeless: the least that a drawing has
    }
    const double least = pixelsOf(resolution.movingExtent(window));
    EXPECT_GT(least, 0.2 * pixelsOf(window));
    EXPECT_LT(least, slower);
    for (int i = 0; i < 50; ++i) {
        resolution.learnShowing(0.0);
    }
    EXPECT_EQ(pixelsOf(resolution.movingExtent(window)), pixelsOf(window));
}

}  // namespace
}  // namespace raytorus::viewer
