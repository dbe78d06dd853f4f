// SPDX-License-Identifier: MIT
// The table of machine code, of rows made up; that a driver counts at all is program_bench_test.cpp's.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/isa.hpp"

namespace raytorus::bench {
namespace {

using trace::Query;

IsaRow row(const char* method, std::uint64_t instructions, std::uint64_t registers, std::uint64_t scratch) {
    return {method,
            Query::Nearest,
            {{"Instructions", instructions},
             {"VGPRs", registers},
             {"Spilled VGPRs", 0},
             {"Scratch size", scratch}},
            1.25};
}

TEST(BenchIsa, HoldsTheAims) {
    const std::vector<IsaRow> good{row("raytorus", 300, 40, 0), row("closed-form-common", 200, 24, 0)};
    EXPECT_NE(isaText(good).find("1.50, held; at most 40 VGPRs: 40, held; nothing spilled, no scratch: held"),
              std::string::npos)
        << isaText(good);
    const std::vector<IsaRow> bad{row("raytorus", 302, 41, 16), row("closed-form-common", 200, 24, 0)};
    EXPECT_NE(isaText(bad).find(
                  "1.51, not held; at most 40 VGPRs: 41, not held; nothing spilled, no scratch: not held"),
              std::string::npos)
        << isaText(bad);
    EXPECT_EQ(isaText(std::vector{row("raytorus", 300, 40, 0)}).find("aims"), std::string::npos);
}

TEST(BenchIsa, LeavesOutWhatTheDriverDoesNotCount) {
    const IsaRow some = row("raytorus", 300, 40, 0);
    EXPECT_EQ(some.of("Instructions"), 300U);
    EXPECT_EQ(some.of("Latency"), std::nullopt);
    EXPECT_NE(isaText(std::vector{some}).find(" - "), std::string::npos);
}

TEST(BenchIsa, WritesEveryStatisticAsJson) {
    gpu::DeviceInfo device;
    device.name = "a GPU";
    device.driverName = "radv";
    device.driverInfo = "Mesa 1";
    const auto table = nlohmann::json::parse(isaJson(device, std::vector{row("raytorus", 300, 40, 0)}));
    EXPECT_EQ(table.at("format"), "raytorus-bench-isa");
    EXPECT_EQ(table.at("version"), 1);
    EXPECT_EQ(table.at("device"), "a GPU");
    EXPECT_EQ(table.at("driver"), "radv Mesa 1");
    EXPECT_EQ(table.at("rows").at(0).at("method"), "raytorus");
    EXPECT_EQ(table.at("rows").at(0).at("query"), "nearest");
    EXPECT_EQ(table.at("rows").at(0).at("VGPRs"), 40);
    EXPECT_EQ(table.at("rows").at(0).at("compileMs"), 1.25);
}

}  // namespace
}  // namespace raytorus::bench
