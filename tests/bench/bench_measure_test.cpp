// SPDX-License-Identifier: MIT
// On the device: rays are those that were written out, answers those of the tracer, checksums theirs; and
// whoever is wrong, or answers otherwise when asked again, is found out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "bench/measure.hpp"
#include "bench/summary.hpp"
#include "raytorus_bench_defective.hpp"
#include "raytorus_bench_fickle.hpp"
#include "support/device_fixture.hpp"
#include "support/fresh_seed.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::bench {
namespace {

using trace::Query;

const Workload tiles{Mode::Made, Pattern::Tiles, 0.25F, 3.0, 50};
const Workload scattered{Mode::Made, Pattern::Scattered, 0.25F, 3.0, 50};

// Both patterns at an opening at which some rays hit and some do not.
RayView viewOf(const Workload& workload) {
    return makeView(workload, 64, test::freshSeed(), 1.5);
}

TimedMethod methodNamed(const char* name) {
    return *std::ranges::find(timedMethods(), name, &TimedMethod::name);
}

class BenchDevice : public test::DeviceTest {
protected:
    Kernel kernel{test::device(), 1};
};

TEST_F(BenchDevice, MakesTheRaysOfTheView) {
    for (const Workload& workload : {tiles, scattered}) {
        const RayView view = viewOf(workload);
        const std::vector<trace::TraceRay> rays = kernel.rays(workload.pattern, view);
        ASSERT_EQ(rays.size(), kernel.rayCount());
        std::vector<float> first;
        for (const trace::TraceRay& ray : rays) {
            // A unit vector and three products, each rounded.
            EXPECT_NEAR(std::hypot(ray.origin[0], ray.origin[1], ray.origin[2]), 3.0F, 1e-6F);
            EXPECT_EQ(ray.tMin, 0.0F);
            EXPECT_EQ(ray.tMax, rayEnd);
            first.push_back(ray.direction[0]);
        }
        std::ranges::sort(first);
        const auto distinct = std::ranges::unique(first).begin() - first.begin();
        EXPECT_GT(distinct, 1000) << "the rays differ";
    }
}

TEST_F(BenchDevice, PutsThePixelsOfATileBesideEachOther) {
    const RayView view = viewOf(tiles);
    const std::vector<trace::TraceRay> rays = kernel.rays(Pattern::Tiles, view);
    // Ray 64 k + i is pixel i of tile k; 8 tiles a row of 64 pixels.
    for (const std::size_t index : {0U, 1U, 8U, 63U, 64U, 64U * 8U, 4095U}) {
        const std::size_t tile = index / 64;
        const std::size_t lane = index % 64;
        const double x = static_cast<double>(tile % 8 * 8 + lane % 8);
        const double y = static_cast<double>(tile / 8 * 8 + lane / 8);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double expected =
                double{view.corner[axis]} + x * double{view.right[axis]} + y * double{view.up[axis]};
            // Four roundings of numbers up to 4.
            EXPECT_NEAR(double{rays[index].direction[axis]}, expected, 1e-6) << index;
        }
    }
}

TEST_F(BenchDevice, ScattersOtherRaysForAnotherSeed) {
    RayView view = viewOf(scattered);
    const std::vector<trace::TraceRay> rays = kernel.rays(Pattern::Scattered, view);
    const auto same = [&rays](const std::vector<trace::TraceRay>& others) {
        return std::memcmp(rays.data(), others.data(), rays.size() * sizeof(trace::TraceRay)) == 0;
    };
    EXPECT_TRUE(same(kernel.rays(Pattern::Scattered, view)));
    view.seed ^= 1U;
    EXPECT_FALSE(same(kernel.rays(Pattern::Scattered, view)));
}

// The library's answers have the bits of those that trace.comp gives to the rays as they were written out.
TEST_F(BenchDevice, AnswersTheRaysThatItWrites) {
    for (const Workload& workload : {tiles, scattered}) {
        const RayView view = viewOf(workload);
        const std::vector<trace::TraceRay> rays = kernel.rays(workload.pattern, view);
        for (const Query query : allQueries) {
            const std::vector<float> answers =
                kernel.answers(methodNamed(ourName), query, workload.pattern, view);
            trace::Tracer tracer(test::device(), query, rays.size());
            const std::span<const float> expected = tracer.trace({view.majorRadius, view.minorRadius}, rays);
            std::size_t differing = 0;
            std::size_t hits = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const float* answer = &answers[i * answerFloats(query)];
                differing += std::memcmp(answer, &expected[i * trace::hitFloats(query)],
                                         answerFloats(query) * sizeof(float)) != 0
                                 ? 1U
                                 : 0U;
                hits += answer[0] != 0.0F ? 1U : 0U;
            }
            EXPECT_EQ(differing, 0U) << workload.name() << " " << nameOf(query);
            EXPECT_GT(hits, rays.size() / 20);
            EXPECT_LT(hits, rays.size() - rays.size() / 20);
        }
    }
}

TEST_F(BenchDevice, AddsUpWhatItAnswers) {
    for (const Workload& workload : {tiles, scattered}) {
        const RayView view = viewOf(workload);
        for (const Query query : allQueries) {
            const TimedMethod ours = methodNamed(ourName);
            const std::vector<float> answers = kernel.answers(ours, query, workload.pattern, view);
            const Shot shot = kernel.time(ours, query, workload.pattern, view, 3);
            EXPECT_EQ(shot.checksum, checksumOf(answers)) << workload.name() << " " << nameOf(query);
            EXPECT_TRUE(shot.layersAgree);
            EXPECT_GT(shot.seconds, 0.0);
            std::vector<float> changed = answers;
            changed.back() = changed.back() == 0.0F ? 1.0F : 0.0F;
            EXPECT_NE(shot.checksum, checksumOf(changed));
        }
    }
}

MeasureOptions smallest() {
    MeasureOptions options;
    options.side = 1;
    options.rounds = 1;
    options.layers = 1;
    options.seed = test::freshSeed();
    return options;
}

const MethodResult& resultOf(const CellResult& cell, const char* name) {
    const MethodResult* found = findMethod(cell, name);
    EXPECT_NE(found, nullptr) << name;
    return found != nullptr ? *found : cell.methods.front();
}

using BenchMeasure = test::DeviceTest;

// What a fast wrong method would be: its faults stand in the table, the library's row is clean.
TEST_F(BenchMeasure, CatchesAPlantedWrongMethod) {
    const std::vector<TimedMethod> methods{methodNamed(emptyName),
                                           methodNamed(ourName),
                                           {"planted", "", trace::ShaderSource(bench_defective::find)}};
    Measurer measurer(test::device(), methods, smallest());
    for (const Workload& workload : {scattered, Workload{Mode::Streamed, Pattern::Scattered}}) {
        const std::vector<CellResult> cells = measurer.measure(workload, allQueries);
        ASSERT_EQ(cells.size(), 3U);
        for (const CellResult& cell : cells) {
            SCOPED_TRACE(cell.workload.name() + " " + nameOf(cell.query));
            // Aiming looks at all 4096 rays; its last step moves them by less than a hundredth.
            EXPECT_NEAR(cell.hitPart, 0.01 * cell.workload.hitPercent, 0.02);
            EXPECT_TRUE(resultOf(cell, ourName).correctness.right());
            const Correctness& planted = resultOf(cell, "planted").correctness;
            EXPECT_GT(planted.judged, 3500U);
            EXPECT_EQ(planted.judged, resultOf(cell, ourName).correctness.judged);
            // An eighth of the rays each, of those that hit or of all.
            EXPECT_GT(planted.wrong, 100U);
            if (cell.query != Query::Any) {
                EXPECT_GT(planted.gross, 30U);
            }
        }
    }
}

TEST_F(BenchMeasure, CatchesAMethodThatAnswersOtherwiseWhenAskedAgain) {
    const std::vector<TimedMethod> methods{methodNamed(emptyName),
                                           methodNamed(ourName),
                                           {"fickle", "", trace::ShaderSource(bench_fickle::find)}};
    MeasureOptions options = smallest();
    options.layers = 3;
    Measurer measurer(test::device(), methods, options);
    for (const Workload& workload : {tiles, Workload{Mode::Streamed, Pattern::Tiles}}) {
        SCOPED_TRACE(workload.name());
        const std::vector<CellResult> cells = measurer.measure(workload, std::array{Query::Nearest});
        ASSERT_EQ(cells.size(), 1U);
        EXPECT_EQ(resultOf(cells[0], "fickle").layers, workload.mode == Mode::Streamed ? 16U : 3U);
        EXPECT_FALSE(resultOf(cells[0], "fickle").checksumHeld);
        EXPECT_TRUE(resultOf(cells[0], "fickle").correctness.right()) << "asked once it is right";
        EXPECT_TRUE(resultOf(cells[0], ourName).checksumHeld);
    }
}

// Every method has its turn, its checksum holds, and the sphere is found to be no torus.
TEST_F(BenchMeasure, RunsEveryMethod) {
    std::vector<TimedMethod> methods{timedMethods().begin(), timedMethods().end()};
    std::erase_if(methods, [](const TimedMethod& method) { return method.needs != Needs::Nothing; });
    Measurer measurer(test::device(), methods, smallest());
    double progress = 0.0;
    const auto follow = [&progress](double part) {
        EXPECT_GE(part, progress);
        progress = part;
    };
    const std::vector<CellResult> cells = measurer.measure(scattered, allQueries, follow);
    EXPECT_EQ(progress, 1.0);
    ASSERT_EQ(cells.size(), 3U);
    for (const CellResult& cell : cells) {
        SCOPED_TRACE(nameOf(cell.query));
        ASSERT_EQ(cell.methods.size(), methods.size());
        for (const MethodResult& method : cell.methods) {
            SCOPED_TRACE(method.name);
            EXPECT_TRUE(method.checksumHeld);
            EXPECT_GT(method.times.minimum, 0.0);
            // From 3 R, at r = R / 4, all but the floors are right on nearly every ray.
            const double bad = static_cast<double>(method.correctness.wrong + method.correctness.gross);
            const double part = bad / std::max(1.0, static_cast<double>(method.correctness.judged));
            if (method.name == "ray-sphere" || method.name == "exact-ends") {
                EXPECT_GT(part, 0.04);  // culling alone is right on nine scattered rays of ten
            } else {
                EXPECT_LT(part, 0.02);
            }
        }
    }
}

}  // namespace
}  // namespace raytorus::bench
