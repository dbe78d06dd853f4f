// SPDX-License-Identifier: MIT
// The library on a device that rounds as badly as Vulkan allows: every verdict stays right, and positions
// lose no more than the bound of docs/accuracy.md says.
#include "loose_arithmetic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "torus_cxx.hpp"
#include "trace/trace_ray.hpp"
#include "verify/ray_group.hpp"

namespace raytorus {
namespace {

using test::Arithmetic;

constexpr std::uint64_t raysPerGroup = 200;

struct Loose {
    const char* name;
    Arithmetic arithmetic;
    double positionBound;  ///< in R + r; see docs/accuracy.md
    double tBound;         ///< in ulp
    double endMargin;      ///< clear, in judge::clearEndMargin: rho is off by as many ulp as a square root
};

void PrintTo(const Loose& loose, std::ostream* out) {
    *out << loose.name;
}

std::vector<verify::RayGroup> clearRayGroups() {
    std::vector<verify::RayGroup> groups = verify::chooseRayGroups({});
    // Loose arithmetic is too coarse for hair-thin tubes.
    std::erase_if(groups, [](const verify::RayGroup& group) {
        return group.passesByMargin() || group.minorRadius < 1e-3F;
    });
    return groups;
}

class LooseArithmetic : public testing::TestWithParam<Loose> {};

TEST_P(LooseArithmetic, ClearRaysAreRight) {
    test::setArithmetic(GetParam().arithmetic);
    verify::Statistics total;
    for (const verify::RayGroup& group : clearRayGroups()) {
        const reference::Torus torus = group.torus();
        for (std::uint64_t i = 0; i < raysPerGroup; ++i) {
            const reference::Ray ray = group.ray(4711, i);
            const judge::ExactHits truth = judge::quickHits(torus, ray);
            if (!judge::isClear(truth, group.tangentMargin(),
                                GetParam().endMargin * judge::clearEndMargin(torus))) {
                continue;
            }
            const trace::TraceRay traced = trace::asTraceRay(ray);
            const judge::Answers answers{test::looseNearest(1.0F, group.minorRadius, traced),
                                         test::looseAll(1.0F, group.minorRadius, traced),
                                         test::looseAny(1.0F, group.minorRadius, traced)};
            const judge::Judgement judgement = judge::judge(torus, ray, truth, answers);
            total.add(torus, ray, truth.count > 0, judgement);
        }
    }
    for (const verify::Example& example : total.examples) {
        ADD_FAILURE() << judge::nameOf(example.fault) << ": "
                      << reference::hexFloats(example.torus, example.ray);
    }
    EXPECT_EQ(total.faultCount(), 0U);
    EXPECT_GT(total.hitting, 30000U);
    EXPECT_LE(total.position.histogram.max(), GetParam().positionBound)
        << reference::hexFloats(total.position.worstTorus, total.position.worstRay);
    EXPECT_LE(total.t.histogram.max(), GetParam().tBound)
        << reference::hexFloats(total.t.worstTorus, total.t.worstRay);
    fmt::print(
        "{} rays; position off by {:.3g} (p99), {:.3g} (max) (R + r); t by {:.3g} (p99), {:.3g} (max) ulp\n",
        total.judged(), total.position.histogram.quantile(0.99), total.position.histogram.max(),
        total.t.histogram.quantile(0.99), total.t.histogram.max());
}

INSTANTIATE_TEST_SUITE_P(
    As, LooseArithmetic,
    // Positions are rounded once, to nearest (2^-24) or to either side (2^-23), and half of 2^-24 is for all
    // else. The t of a short ray, which stands for 2^-27 (R + r) an ulp, gathers several roundings.
    testing::Values(
        Loose{"nearest", {}, 9e-8, 2.0, 1.0},
        Loose{
            "looseDivision", {false, test::allowedDivisionUlps, test::allowedSquareRootUlps}, 9e-8, 6.0, 6.0},
        Loose{"anyRounding", {true, 0, 0}, 1.5e-7, 2.0, 2.0},
        Loose{"all", {true, test::allowedDivisionUlps, test::allowedSquareRootUlps}, 1.5e-7, 6.0, 7.0}),
    [](const auto& row) { return std::string(row.param.name); });

// The loose float without its looseness is a float: what the tests above show is the looseness.
TEST(LooseArithmetic, IsExactWhenToldToBe) {
    test::setArithmetic({});
    for (const verify::RayGroup& group : clearRayGroups()) {
        const trace::TraceRay ray = trace::asTraceRay(group.ray(815, 0));
        const trace::AllHits loose = test::looseAll(1.0F, group.minorRadius, ray);
        const trace::AllHits exact = test::cxxAll(1.0F, group.minorRadius, ray);
        EXPECT_EQ(std::memcmp(&loose, &exact, sizeof(loose)), 0);
    }
}

}  // namespace
}  // namespace raytorus
