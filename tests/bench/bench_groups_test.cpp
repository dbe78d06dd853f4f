// SPDX-License-Identifier: MIT
// What a group of lanes pays, of paths made up; that the shaders count at all is program_bench_test.cpp's.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "bench/groups.hpp"

namespace raytorus::bench {
namespace {

constexpr PartCosts costs{100, 10, 50, 200};

// A ray with so many steps in its first two passes, a refinement in those of which the bits are set, and so
// many hits.
RayPath path(std::uint32_t first, std::uint32_t second, std::uint32_t refiningPasses, std::uint32_t hits) {
    const std::uint32_t refinements = (refiningPasses & 1U) + (refiningPasses >> 1U);
    return {first + second, first | second << 4U, refiningPasses, hits | refinements << 8U};
}

TEST(BenchGroups, PayForTheSlowestRayOfEachPass) {
    // Two rays that are slow in different passes are slower together than either.
    const std::vector<RayPath> group{path(4, 1, 0b10, 1), path(2, 3, 0b10, 1)};
    EXPECT_EQ(groupInstructions(group, costs), 100 + (4 + 3) * 10 + 50);
}

TEST(BenchGroups, PayForEveryPassInWhichARayRefines) {
    const std::vector<RayPath> group{path(1, 0, 0b01, 1), path(4, 1, 0b10, 1), path(0, 0, 0, 0)};
    EXPECT_EQ(groupInstructions(group, costs), 100 + (4 + 1) * 10 + 2 * 50);
}

TEST(BenchGroups, PayForTheStepsOfLatePasses) {
    RayPath late = path(4, 4, 0, 0);
    late.steps = 20;
    EXPECT_EQ(groupInstructions(std::vector{late}, costs), 100 + 20 * 10);
}

TEST(BenchGroups, AverageOverGroupsAndRays) {
    // 64 rays, one of which is slow and refines twice for its hit.
    std::vector<RayPath> paths(64, path(1, 0, 0, 0));
    paths[40] = path(4, 3, 0b11, 1);
    const GroupRow row = groupRow(paths, costs);
    EXPECT_EQ(row.count, 64U);
    EXPECT_DOUBLE_EQ(row.hitPart, 1.0 / 64);
    EXPECT_DOUBLE_EQ(row.steps, (63.0 + 7.0) / 64);
    EXPECT_DOUBLE_EQ(row.slowest[0], (7 * 1.0 + 7.0) / 8) << "one group of eight of eight";
    EXPECT_DOUBLE_EQ(row.slowest[1], (1.0 + 7.0) / 2);
    EXPECT_DOUBLE_EQ(row.slowest[2], 7.0);
    EXPECT_DOUBLE_EQ(row.refiningRays, 1.0 / 64);
    EXPECT_DOUBLE_EQ(row.refiningGroups, 1.0);
    EXPECT_DOUBLE_EQ(row.instructions[1], (110.0 + 100 + 70 + 100) / 2);
}

TEST(BenchGroups, DoNotCountTheLastStepOfAHit) {
    const GroupRow row = groupRow(std::vector<RayPath>(64, path(2, 0, 0b01, 1)), costs);
    EXPECT_EQ(row.refiningRays, 0.0);
    EXPECT_EQ(row.refiningGroups, 0.0);
}

TEST(BenchGroups, AreWrittenAsJson) {
    GroupRow row = groupRow(std::vector<RayPath>(64, path(2, 0, 0b01, 1)), costs);
    row.rays = "tiles";
    gpu::DeviceInfo device;
    device.name = "a GPU";
    const auto json = nlohmann::json::parse(groupsJson(device, 7, std::vector{row}, costs));
    EXPECT_EQ(json.at("format"), "raytorus-bench-groups");
    EXPECT_EQ(json.at("device"), "a GPU");
    EXPECT_EQ(json.at("seed"), 7);
    EXPECT_EQ(json.at("parts").at("step"), 10);
    EXPECT_EQ(json.at("rows").at(0).at("rays"), "tiles");
    EXPECT_EQ(json.at("rows").at(0).at("slowest").at("64"), 2);
    EXPECT_EQ(json.at("rows").at(0).at("instructions").at("64"), 170);
}

TEST(BenchGroups, SayWhatTheyDoNotKnow) {
    const std::vector<GroupRow> rows{groupRow(std::vector<RayPath>(64, path(2, 0, 0b01, 1)), std::nullopt)};
    EXPECT_NE(groupsText(rows, std::nullopt).find("they need Mesa's radv"), std::string::npos);
    gpu::DeviceInfo device;
    const auto json = nlohmann::json::parse(groupsJson(device, 7, rows, std::nullopt));
    EXPECT_FALSE(json.contains("parts"));
    EXPECT_FALSE(json.at("rows").at(0).contains("instructions"));
}

}  // namespace
}  // namespace raytorus::bench
