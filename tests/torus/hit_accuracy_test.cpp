// SPDX-License-Identifier: MIT
// Fresh rays through the real SPIR-V, judged by the reference: on clear rays nothing is missed, nothing
// invented, and positions are right to a few roundings. The seed is printed; set RAYTORUS_SEED to replay a
// run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "hit_judge.hpp"
#include "support/device_fixture.hpp"
#include "support/fresh_seed.hpp"
#include "verify/verifier.hpp"

namespace raytorus {
namespace {

using reference::RayClass;

// A position is the exact one, rounded: it is off the surface by no more than it is off the exact one.
constexpr double maxOffSurface = judge::positionBound;

class HitAccuracy : public test::DeviceTest, public testing::WithParamInterface<RayClass> {};

TEST_P(HitAccuracy, ClearRaysAreRight) {
    constexpr std::uint64_t raysPerCase = 600;
    test::HitJudge judge(raysPerCase);
    test::HitTally all;
    for (const float minorRadius : {0.001F, 0.01F, 0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F}) {
        for (const double distance : {1.5, 3.0, 10.0, 100.0, 1e3, 1e4, 1e6}) {
            reference::RayParameters parameters;
            parameters.torus = {1.0F, minorRadius};
            parameters.distance = distance;
            parameters.seed = test::freshSeed();
            const std::string name = fmt::format("{} r/R {} D/R {} seed {}", reference::nameOf(GetParam()),
                                                 minorRadius, distance, parameters.seed);
            const auto rays = reference::generateRays(GetParam(), parameters, raysPerCase);
            const test::HitTally judgement = judge.judge(parameters.torus, rays, name);
            for (const std::string& fault : judgement.faults) {
                ADD_FAILURE() << fault;
            }
            EXPECT_EQ(judgement.faultCount, 0U) << name;
            EXPECT_LE(judgement.offSurface, maxOffSurface) << name;
            all.judged += judgement.judged;
            all.hits += judgement.hits;
            all.positionError = std::max(all.positionError, judgement.positionError);
            all.tError = std::max(all.tError, judgement.tError);
        }
    }
    EXPECT_GT(all.judged, 63 * raysPerCase / 2) << "the class is to have mostly clear rays";
    EXPECT_GT(all.hits, 63 * raysPerCase / 20) << "the class is to hit";
    RecordProperty("largestPositionError", fmt::format("{:.3g}", all.positionError));
    RecordProperty("largestTError", fmt::format("{:.3g}", all.tError));
    fmt::print("{} clear rays, {} hit; position off by at most {:.3g} (R + r), t by {:.3f} ulp\n", all.judged,
               all.hits, all.positionError, all.tError);
}

using Grazing = test::DeviceTest;

// Rays that pass the surface, or dip into it, by a few millionths of r, from up to 100 R away: many nearer
// than that, since the rounding of their origins moves them. What may be wrong of them is what moves when the
// last bits of the line do. In 18 runs that was at most 6 of 12 000 rays at r/R = 0.001, 1 at 0.01, and
// none from 0.1 on; the bars leave room for three times as many. The best others are wrong for a quarter.
TEST_F(Grazing, VerdictsAreNearlyAlwaysRight) {
    constexpr std::uint64_t raysPerCase = 3000;
    test::HitJudge judge(raysPerCase);
    for (int i = 0; i < 12; ++i) {
        const float minorRadius =
            std::array{0.001F, 0.01F, 0.1F, 0.25F, 0.5F, 1.0F}[static_cast<std::size_t>(i) % 6];
        const double margin = i < 6 ? 3e-6 : 3e-5;
        const double mayBeWrong = minorRadius < 0.1F ? 1.5e-3 : 2.5e-4;  // in parts of the rays
        test::HitTally all;
        for (const double distance : {1.5, 3.0, 10.0, 100.0}) {
            reference::RayParameters parameters;
            parameters.torus = {1.0F, minorRadius};
            parameters.distance = distance;
            parameters.margin = margin;
            parameters.seed = test::freshSeed();
            const auto rays = reference::generateRays(RayClass::grazing, parameters, raysPerCase);
            const test::HitTally judgement = judge.judgeVerdicts(parameters.torus, rays, "grazing");
            all.judged += judgement.judged;
            all.faultCount += judgement.faultCount;
            all.faults.insert(all.faults.end(), judgement.faults.begin(), judgement.faults.end());
        }
        fmt::print("r/R {:<6} margin {:g} r: {} of {} wrong\n", minorRadius, margin, all.faultCount,
                   all.judged);
        EXPECT_GT(all.judged, raysPerCase);
        EXPECT_LE(static_cast<double>(all.faultCount), mayBeWrong * static_cast<double>(all.judged))
            << (all.faults.empty() ? "" : all.faults.front());
    }
}

// Where the margins are those of the rays as rounded, fewer are wrong: 5 runs had 0 to 2 of these. With a
// foot for the exact solver that is not quite perpendicular to its line, which the bars above let pass, there
// were 19 and 23.
TEST_F(Grazing, ThinTubesAreRightToTheMargin) {
    verify::Verifier verifier(test::device());
    verify::Statistics all;
    for (const double distance : {1.5, 3.0, 10.0, 100.0}) {
        all.merge(
            verifier.verify({RayClass::grazing, 0.001F, distance, 1e-6, 1e-4}, test::freshSeed(), 50000));
    }
    const std::uint64_t wrong = all.faultCount() - all.faultsOf(judge::Fault::Gross);
    fmt::print("{} of {} wrong\n", wrong, all.judged());
    EXPECT_LE(wrong, 10U);
}

INSTANTIATE_TEST_SUITE_P(Classes, HitAccuracy, testing::ValuesIn([] {
                             std::vector<RayClass> classes(std::begin(reference::allRayClasses),
                                                           std::end(reference::allRayClasses));
                             std::erase_if(classes, reference::passesByMargin);
                             return classes;
                         }()),
                         [](const auto& row) { return std::string(reference::nameOf(row.param)); });

}  // namespace
}  // namespace raytorus
