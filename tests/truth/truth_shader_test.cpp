// SPDX-License-Identifier: MIT
// The shaders' pictures, held to the truth: every shipped scene, and fresh random ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "random_scene.hpp"
#include "render/renderer.hpp"
#include "scene/scene_json.hpp"
#include "support/device_fixture.hpp"
#include "support/fresh_seed.hpp"
#include "truth/truth.hpp"
#include "truth_judge.hpp"

namespace raytorus::test {
namespace {

// The picture by the fragment route, held to the truth.
TruthJudgement judgeShaders(const scene::Scene& scene, int width, int height, int samplesPerSide) {
    render::RenderOptions options;
    options.width = width;
    options.height = height;
    options.samplesPerSide = samplesPerSide;
    truth::TruthOptions exact;
    exact.samplesPerSide = samplesPerSide;
    exact.sharpness = true;
    const auto start = std::chrono::steady_clock::now();
    const image::Image expected = truth::renderTruth(scene, width, height, exact);
    const auto rendered = std::chrono::steady_clock::now();
    TruthJudgement judgement = judgeByTruth(expected, render::render(device(), scene, options).picture);
    judgement.seconds = std::chrono::duration<double>(rendered - start).count();
    return judgement;
}

void expectRight(const TruthJudgement& judgement, const std::string& name) {
    constexpr std::size_t shown = 5;
    for (std::size_t i = 0; i < std::min(judgement.faults.size(), shown); ++i) {
        ADD_FAILURE() << name << ", " << judgement.faults[i];
    }
    EXPECT_EQ(judgement.faults.size(), 0U) << name;
}

void print(const TruthJudgement& judgement) {
    fmt::print(
        "the truth took {:.2f} s; of {} pixels may flip: {} the hit, {} the count, {} the colour; {} do\n",
        judgement.seconds, judgement.pixels, judgement.doubtful, judgement.doubtfulCount,
        judgement.doubtfulColor, judgement.flipped);
    for (const ToleranceUse& use : judgement.uses) {
        fmt::print("{:<10} largest difference / tolerance {:.3f}\n", use.tolerance, use.largestRatio);
    }
}

using TruthRandomScenes = DeviceTest;
class TruthShaders : public DeviceTest, public testing::WithParamInterface<const char*> {};

TEST_P(TruthShaders, DrawTheShippedScene) {
    const std::string name = GetParam();
    const TruthJudgement judgement = judgeShaders(
        scene::readScene(fmt::format("{}/scenes/{}.json", RAYTORUS_SOURCE_DIR, name)), 96, 64, 1);
    print(judgement);
    expectRight(judgement, name);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TruthShaders,
                         testing::Values("ring", "chain", "thin", "far", "inside", "nested", "spindle",
                                         "turntable"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST_F(TruthRandomScenes, AreDrawnRight) {
    constexpr std::uint64_t scenes = 24;
    TruthJudgement all;
    for (std::uint64_t i = 0; i < scenes; ++i) {
        const RandomScene drawn = randomScene(freshSeed(), i);
        const int samplesPerSide = i % 10 == 0 ? 2 + static_cast<int>(i / 10) % 2 : 1;
        const TruthJudgement judgement = judgeShaders(drawn.scene, 24, 16, samplesPerSide);
        expectRight(judgement, drawn.description);
        all.add(judgement);
    }
    print(all);
}

TEST(TruthJudge, FaultsWhatIsOffByMoreThanItsTolerance) {
    const scene::Scene scene = scene::readScene(fmt::format("{}/scenes/ring.json", RAYTORUS_SOURCE_DIR));
    truth::TruthOptions exact;
    exact.sharpness = true;
    const image::Image expected = truth::renderTruth(scene, 24, 16, exact);
    EXPECT_TRUE(judgeByTruth(expected, expected).faults.empty());
    const std::pair<const char*, const char*> checks[] = {
        {"R", "tolerance.color"},         {"t", "tolerance.t"},     {"position.y", "tolerance.position"},
        {"normal.z", "tolerance.normal"}, {"uv.u", "tolerance.uv"}, {"id", "margin"},
        {"count", "margin.count"}};
    for (const auto& [channel, tolerance] : checks) {
        image::Image actual = expected;
        const auto pixel = actual.pixel(12, 11);
        const auto at = [&actual](const char* name) {
            return static_cast<std::size_t>(actual.channelIndex(name));
        };
        const float limit = pixel[at(tolerance)];
        pixel[at(channel)] += 1.5F * limit;
        EXPECT_EQ(judgeByTruth(expected, actual).faults.size(), 1U) << channel;
    }
}

}  // namespace
}  // namespace raytorus::test
