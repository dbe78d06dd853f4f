// SPDX-License-Identifier: MIT
// The judge sees each kind of fault, and measures what is off in the units it promises.
#include "judge/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "verify/ray_group.hpp"

namespace raytorus::judge {
namespace {

const reference::Torus ring{1.0F, 0.25F};
// Along the x axis: in at -1.25, out at -0.75, in at 0.75, out at 1.25.
const reference::Ray alongX{{-3.0F, 0.0F, 0.0F}, 0.0F, {1.0F, 0.0F, 0.0F}, 10.0F};
const reference::Ray passing{{-3.0F, 0.0F, 2.0F}, 0.0F, {1.0F, 0.0F, 0.0F}, 10.0F};

// The right answers of `alongX`, to be spoiled.
struct Said {
    trace::NearestHit nearest{1.0F, 1.75F, {-1.25F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}};
    trace::AllHits all{
        4.0F,
        {1.75F, 2.25F, 3.75F, 4.25F},
        {{-1.25F, 0.0F, 0.0F}, {-0.75F, 0.0F, 0.0F}, {0.75F, 0.0F, 0.0F}, {1.25F, 0.0F, 0.0F}}};
    float any = 1.0F;

    [[nodiscard]] Judgement judged(const reference::Ray& about = alongX) const {
        return judge(ring, about, arbiterHits(ring, about), {nearest, all, any});
    }
};

TEST(Judge, RightAnswersAreRight) {
    const Judgement judgement = Said().judged();
    EXPECT_EQ(judgement.fault, Fault::None);
    ASSERT_EQ(judgement.hitCount, 4);
    for (const HitErrors& errors : judgement.errors) {
        EXPECT_EQ(errors.position, 0.0);
        EXPECT_EQ(errors.t, 0.0);
        EXPECT_LT(errors.surface, 1e-15);
    }
}

TEST(Judge, NoHitIsRightWhereThereIsNone) {
    Said said;
    said.nearest = {0.0F, 10.0F, {}, {}};
    said.all = {0.0F, {10.0F, 10.0F, 10.0F, 10.0F}, {}};
    said.any = 0.0F;
    EXPECT_EQ(said.judged(passing).fault, Fault::None);
    EXPECT_EQ(said.judged(passing).hitCount, 0);
}

TEST(Judge, SeesAMissedHit) {
    Said said;
    said.nearest.hit = 0.0F;
    EXPECT_EQ(said.judged().fault, Fault::Missed);
}

TEST(Judge, SeesAFalseHit) {
    EXPECT_EQ(Said().judged(passing).fault, Fault::FalseHit);
}

TEST(Judge, SeesAWrongCount) {
    Said said;
    said.all.count = 2.0F;
    EXPECT_EQ(said.judged().fault, Fault::WrongCount);
    EXPECT_EQ(said.judged().hitCount, 0) << "hits cannot be told apart, so none is measured";
}

TEST(Judge, SeesHitsOutOfOrder) {
    Said said;
    std::swap(said.all.t[1], said.all.t[2]);
    EXPECT_EQ(said.judged().fault, Fault::Order);
}

TEST(Judge, SeesThatAnyHitDisagrees) {
    Said said;
    said.any = 0.0F;
    EXPECT_EQ(said.judged().fault, Fault::Disagreement);
}

TEST(Judge, SeesANearestHitThatIsNotTheFirst) {
    Said said;
    said.nearest.t = std::nextafter(1.75F, 2.0F);
    EXPECT_EQ(said.judged().fault, Fault::Disagreement);
    said = Said();
    said.nearest.position[1] = -0.0F;
    EXPECT_EQ(said.judged().fault, Fault::Disagreement) << "to the bit";
}

TEST(Judge, SeesWhatIsNotFinite) {
    Said said;
    said.nearest.t = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(said.judged().fault, Fault::NonFinite);
    said = Said();
    said.all.position[3][2] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(said.judged().fault, Fault::NonFinite);
}

TEST(Judge, SeesAGrossError) {
    Said said;
    said.all.position[2][0] += 0.24F * 0.01F;
    EXPECT_EQ(said.judged().fault, Fault::None);
    said.all.position[2][0] += 0.02F * 0.01F;
    EXPECT_EQ(said.judged().fault, Fault::Gross) << "0.01 minor radii and more";
}

TEST(Judge, MeasuresPositionsInTheTorusSize) {
    Said said;
    said.all.position[1][2] = 0.00125F;
    EXPECT_NEAR(said.judged().errors[1].position, 1e-3, 1e-9);
}

TEST(Judge, MeasuresTInUlpsOfItself) {
    Said said;
    said.all.t[3] = std::nextafter(std::nextafter(4.25F, 5.0F), 5.0F);
    EXPECT_DOUBLE_EQ(said.judged().errors[3].t, 2.0);
}

TEST(Judge, MeasuresAShortTInUlpsOfASixteenthOfTheTorus) {
    // Starts 2^-10 before the surface: t is 2^-10, and its own ulp 2^-33.
    const reference::Ray close{{-1.25F - 0x1p-10F, 0.0F, 0.0F}, 0.0F, {1.0F, 0.0F, 0.0F}, 0.25F};
    Said said;
    said.nearest = {1.0F, 0x1p-10F, {-1.25F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}};
    said.all = {1.0F, {0x1p-10F + 0x1p-27F, 10.0F, 10.0F, 10.0F}, {{-1.25F, 0.0F, 0.0F}}};
    EXPECT_NEAR(said.judged(close).errors[0].t, 1.0, 1e-6) << "(R + r) / 16 = 1.25 / 16: ulp 2^-27";
}

TEST(Judge, MeasuresTheDistanceFromTheSurface) {
    Said said;
    said.all.position[0][0] = -1.25F - 0.000125F;
    EXPECT_NEAR(said.judged().errors[0].surface, 1e-4, 1e-7);
}

// The fast truths are what millions of rays are judged by.
TEST(Truth, IsTheArbitersOnClearRays) {
    std::size_t hits = 0;
    for (const verify::RayGroup& group : verify::chooseRayGroups({})) {
        const reference::Torus shape = group.torus();
        for (std::uint64_t i = 0; i < 8; ++i) {
            const reference::Ray drawn = group.ray(11, i);
            const ExactHits exact = arbiterHits(shape, drawn);
            if (!isClear(exact, group.tangentMargin(), 0.0)) {
                continue;
            }
            const bool precise = group.needsPreciseHits();
            const ExactHits fast = precise ? preciseHits(shape, drawn) : quickHits(shape, drawn);
            const double bound = (precise ? 1e-15 : 1e-10) * (1.0 + static_cast<double>(group.minorRadius));
            ASSERT_EQ(fast.count, exact.count) << reference::hexFloats(shape, drawn);
            EXPECT_NEAR(fast.clearance, exact.clearance, 1e-9 + 1e-9 * exact.clearance);
            for (std::size_t k = 0; k < static_cast<std::size_t>(exact.count); ++k) {
                ++hits;
                EXPECT_EQ(fast.hits[k].entering, exact.hits[k].entering);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    EXPECT_NEAR(fast.hits[k].position[axis], exact.hits[k].position[axis], bound)
                        << reference::hexFloats(shape, drawn);
                }
                EXPECT_NEAR(fast.hits[k].t, exact.hits[k].t, 1e-10 * std::abs(exact.hits[k].t) + bound);
            }
        }
    }
    EXPECT_GT(hits, 2000U);
}

}  // namespace
}  // namespace raytorus::judge
