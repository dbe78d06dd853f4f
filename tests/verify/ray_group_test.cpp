// SPDX-License-Identifier: MIT
// Which ray groups there are, which rays they hold, and which thresholds are exceeded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "verify/thresholds.hpp"

namespace raytorus::verify {
namespace {

using reference::RayClass;

std::size_t countOf(const std::vector<RayGroup>& groups, RayClass rayClass) {
    return static_cast<std::size_t>(std::count_if(
        groups.begin(), groups.end(), [&](const RayGroup& group) { return group.rayClass == rayClass; }));
}

TEST(RayGroups, AreEveryCombination) {
    const std::vector<RayGroup> groups = chooseRayGroups({});
    EXPECT_EQ(countOf(groups, RayClass::camera), 13U * 7U);
    EXPECT_EQ(countOf(groups, RayClass::inside), 13U) << "starts at the torus, at no distance";
    EXPECT_EQ(countOf(groups, RayClass::grazing), 13U * 4U * 2U) << "two margins, up to 100 R";
    EXPECT_EQ(countOf(groups, RayClass::hornTip), 4U * 2U) << "of the horn alone";
    EXPECT_EQ(countOf(groups, RayClass::dimpleCone), 4U * 2U) << "of the spindle alone";
    for (const RayClass rayClass : reference::allRayClasses) {
        EXPECT_GE(countOf(groups, rayClass), 8U) << reference::nameOf(rayClass);
    }
}

TEST(RayGroups, AreThoseThatAreChosen) {
    const std::vector<RayGroup> groups =
        chooseRayGroups({{RayClass::camera, RayClass::hole}, {0.1F, 0.5F}, {7.0}});
    EXPECT_EQ(groups.size(), 4U);
    EXPECT_EQ(countOf(groups, RayClass::hole), 2U);
    EXPECT_EQ(groups[0].distance, 7.0);
}

TEST(RayGroups, HoldTheSameRaysForTheSameSeed) {
    for (const RayClass rayClass : reference::allRayClasses) {
        const RayGroup group{rayClass, 0.25F, 3.0, 1e-6, 1e-5};
        const reference::Ray first = group.ray(5, 77);
        const reference::Ray again = group.ray(5, 77);
        const reference::Ray other = group.ray(6, 77);
        EXPECT_EQ(std::memcmp(&first, &again, sizeof(first)), 0);
        EXPECT_NE(std::memcmp(&first, &other, sizeof(first)), 0) << reference::nameOf(rayClass);
    }
}

TEST(RayGroups, SpreadTheirMarginsEvenlyOverTheOctaves) {
    const RayGroup group{RayClass::grazing, 0.25F, 3.0, 1e-6, 1e-4};
    const reference::Torus torus{1.0F, 0.25F};
    int below = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
        const double clearance = judge::arbiterHits(torus, group.ray(3, i)).clearance;
        EXPECT_LT(clearance, 1.1e-4);
        below += clearance < 1e-5 ? 1 : 0;
    }
    EXPECT_NEAR(below, 200, 60)
        << "half of them below the middle, four standard deviations and what else is closer";
}

// A ray group of 1000 rays, right but for what the caller spoils.
Statistics statisticsWith(double positionError, double tError, std::uint64_t faults) {
    const reference::Torus torus{1.0F, 0.25F};
    const reference::Ray ray{};
    Statistics statistics;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        judge::Judgement judgement;
        judgement.fault = i < faults ? judge::Fault::Missed : judge::Fault::None;
        judgement.hitCount = 1;
        judgement.errors[0] = {3e-8, 0.3, 3e-8};
        if (i == 500) {
            judgement.errors[0] = {positionError, tError, positionError};
        }
        statistics.add(torus, ray, true, judgement);
    }
    return statistics;
}

TEST(Thresholds, AreHeldByRoundedHits) {
    EXPECT_TRUE(exceededThresholds(RayGroup{}, statisticsWith(6e-8, 0.5, 0)).empty());
}

TEST(Thresholds, AreExceededByOneFault) {
    const auto exceeded = exceededThresholds(RayGroup{}, statisticsWith(6e-8, 0.5, 1));
    ASSERT_EQ(exceeded.size(), 1U);
    EXPECT_EQ(exceeded[0], "camera r/R 0.25 D/R 3: 1 of 1000 rays are wrong, 0 may be");
}

TEST(Thresholds, AreExceededByOnePosition) {
    const auto exceeded = exceededThresholds(RayGroup{}, statisticsWith(1e-7, 0.5, 0));
    ASSERT_EQ(exceeded.size(), 2U) << "the position, and its distance from the surface";
    EXPECT_EQ(exceeded[0],
              "camera r/R 0.25 D/R 3: the largest position error is 1e-07 (R + r), 9e-08 is allowed");
}

TEST(Thresholds, AreExceededByOneT) {
    const auto exceeded = exceededThresholds(RayGroup{}, statisticsWith(6e-8, 2.5, 0));
    ASSERT_EQ(exceeded.size(), 1U);
    EXPECT_NE(exceeded[0].find("error of t is 2.5 ulp"), std::string::npos);
}

TEST(Thresholds, LetAPartOfGrazingRaysBeWrong) {
    const RayGroup thin{RayClass::grazing, 1e-6F, 3.0, 1e-6, 1e-5};
    EXPECT_TRUE(exceededThresholds(thin, statisticsWith(1.0, 1e6, 2)).empty()) << "positions are free";
    EXPECT_EQ(exceededThresholds(thin, statisticsWith(6e-8, 0.5, 3)).size(), 1U);
    const RayGroup thinner{RayClass::grazing, 1e-7F, 3.0, 1e-6, 1e-5};
    EXPECT_TRUE(exceededThresholds(thinner, statisticsWith(6e-8, 0.5, 7)).empty())
        << "0.19 %, and what chance makes of it: 1.9 + 4 sqrt(1.9)";
    EXPECT_EQ(exceededThresholds(thinner, statisticsWith(6e-8, 0.5, 8)).size(), 1U);
    const RayGroup rare{RayClass::grazing, 0.001F, 3.0, 1e-6, 1e-5};
    EXPECT_TRUE(exceededThresholds(rare, statisticsWith(6e-8, 0.5, 2)).empty()) << "two of however few";
    EXPECT_EQ(exceededThresholds(rare, statisticsWith(6e-8, 0.5, 3)).size(), 1U);
    const RayGroup wide{RayClass::grazing, 0.25F, 3.0, 1e-5, 1e-4};
    EXPECT_EQ(exceededThresholds(wide, statisticsWith(6e-8, 0.5, 1)).size(), 1U) << "none";
}

TEST(Thresholds, LetTheTOfAHairThinTubeBeAsFarOffAsItsRounding) {
    const RayGroup thin{RayClass::inside, 1e-6F, 0.0};
    EXPECT_TRUE(exceededThresholds(thin, statisticsWith(6e-8, 20, 0)).empty());
    EXPECT_EQ(exceededThresholds(thin, statisticsWith(6e-8, 100, 0)).size(), 1U);
    EXPECT_EQ(exceededThresholds(thin, statisticsWith(6e-8, 0.5, 1)).size(), 1U);
    const RayGroup thinner{RayClass::camera, 1e-7F, 3.0};
    EXPECT_TRUE(exceededThresholds(thinner, statisticsWith(6e-8, 0.5, 2)).empty());
    EXPECT_EQ(exceededThresholds(thinner, statisticsWith(6e-8, 0.5, 3)).size(), 1U);
}

TEST(Thresholds, OfTheFastTierAreItsOwn) {
    constexpr auto fast = reference::Tier::Fast;
    EXPECT_TRUE(exceededThresholds(RayGroup{}, statisticsWith(5e-3, 1e4, 0), fast).empty());
    EXPECT_EQ(exceededThresholds(RayGroup{}, statisticsWith(2e-2, 1e4, 0), fast).size(), 2U)
        << "the position and the surface";
    EXPECT_EQ(exceededThresholds(RayGroup{}, statisticsWith(6e-8, 3e6, 0), fast).size(), 1U) << "t";
    EXPECT_EQ(exceededThresholds(RayGroup{}, statisticsWith(6e-8, 0.5, 1), fast).size(), 1U)
        << "no verdict is wrong";
    const RayGroup far{RayClass::camera, 0.25F, 1e4};
    EXPECT_TRUE(exceededThresholds(far, statisticsWith(1.0, 1e6, 7), fast).empty())
        << "0.2 %, positions are free";
    EXPECT_EQ(exceededThresholds(far, statisticsWith(6e-8, 0.5, 8), fast).size(), 1U);
    for (const float radius : {0.01F, 1.5F}) {
        const RayGroup rare{RayClass::segment, radius, 3.0};
        EXPECT_TRUE(exceededThresholds(rare, statisticsWith(6e-8, 0.5, 2), fast).empty()) << "one of 100 000";
        EXPECT_EQ(exceededThresholds(rare, statisticsWith(6e-8, 0.5, 3), fast).size(), 1U);
    }
    const RayGroup horn{RayClass::throughAxis, 1.0F, 3.0};
    EXPECT_TRUE(exceededThresholds(horn, statisticsWith(6e-8, 0.5, 13), fast).empty()) << "its tip is flat";
    EXPECT_EQ(exceededThresholds(horn, statisticsWith(6e-8, 0.5, 14), fast).size(), 1U);
    const RayGroup grazing{RayClass::grazing, 0.25F, 3.0, 1e-6, 1e-5};
    EXPECT_TRUE(exceededThresholds(grazing, statisticsWith(1.0, 1e6, 900), fast).empty())
        << "it promises nothing there";
}

TEST(Statistics, AddUp) {
    Statistics sum = statisticsWith(5e-8, 0.4, 7);
    sum.merge(statisticsWith(7e-8, 0.3, 2));
    EXPECT_EQ(sum.judged(), 2000U);
    EXPECT_EQ(sum.faultCount(), 9U);
    EXPECT_EQ(sum.faultsOf(judge::Fault::Missed), 9U);
    EXPECT_EQ(sum.examples.size(), Statistics::maxExamples);
    EXPECT_EQ(sum.position.histogram.max(), 7e-8);
    EXPECT_EQ(sum.t.histogram.max(), 0.4);
}

}  // namespace
}  // namespace raytorus::verify
