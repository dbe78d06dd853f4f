// SPDX-License-Identifier: MIT
// Answers that are right are found right, and every kind of fault is counted once.
#include <gtest/gtest.h>

#include "bench/correctness.hpp"
#include "bench/kernel.hpp"
#include "reference/rays.hpp"
#include "support/fresh_seed.hpp"
#include "support/special_floats.hpp"
#include "trace/trace_ray.hpp"
#include "truth/reference_tracer.hpp"

namespace raytorus::bench {
namespace {

using trace::Query;

constexpr reference::Torus ring{1.0F, 0.25F};
constexpr std::size_t rayCount = 300;

std::vector<trace::TraceRay> someRays() {
    reference::RayParameters parameters;
    parameters.torus = ring;
    parameters.seed = test::freshSeed();
    return trace::asTraceRays(reference::generateRays(reference::RayClass::camera, parameters, rayCount));
}

// What the reference answers, in the layout of Kernel::answers.
std::vector<float> exactAnswers(Query query, const std::vector<trace::TraceRay>& rays) {
    const std::vector<float> stored = truth::traceByReference(query, ring, rays);
    std::vector<float> answers;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::size_t at = i * trace::hitFloats(query);
        for (std::size_t k = 0; k < answerFloats(query); ++k) {
            answers.push_back(stored[at + k]);
        }
    }
    return answers;
}

class BenchCorrectness : public testing::Test {
protected:
    [[nodiscard]] Correctness judge(Query query, const std::vector<float>& answers) {
        return expected.judge(query, answers);
    }
    // The first ray whose answer has at least so many hits, and that is judged.
    [[nodiscard]] std::size_t rayWith(int hits) const {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const judge::ExactHits truth = judge::arbiterHits(ring, trace::asReferenceRay(rays[i]));
            if (truth.count >= hits &&
                judge::isClear(truth, judge::clearMargin, judge::clearEndMargin(ring))) {
                return i;
            }
        }
        ADD_FAILURE() << "no ray with " << hits << " hits";
        return 0;
    }

    std::vector<trace::TraceRay> rays = someRays();
    ReferenceHits expected{ring, rays, 2};
};

TEST_F(BenchCorrectness, FindsTheReferenceRight) {
    std::size_t hits = 0;
    for (const Query query : allQueries) {
        const std::vector<float> answers = exactAnswers(query, rays);
        const Correctness correctness = judge(query, answers);
        EXPECT_GT(correctness.judged, rayCount * 9 / 10) << nameOf(query);
        EXPECT_EQ(correctness.wrong, 0U) << nameOf(query);
        EXPECT_EQ(correctness.gross, 0U) << nameOf(query);
        // Rounded once to float32: 2^-24 in each coordinate, of 1.25 at most.
        EXPECT_LE(correctness.positionP99, 9e-8) << nameOf(query);
        EXPECT_TRUE(correctness.right());
        if (query == Query::Any) {
            for (const float answer : answers) {
                hits += answer != 0.0F ? 1U : 0U;
            }
        }
    }
    EXPECT_DOUBLE_EQ(expected.hitPart(), static_cast<double>(hits) / rayCount);
    EXPECT_DOUBLE_EQ(hitPartOf(ring, rays, 1), expected.hitPart());
}

TEST_F(BenchCorrectness, CountsAWrongVerdict) {
    for (const Query query : allQueries) {
        for (const int hits : {1, 0}) {
            std::vector<float> answers = exactAnswers(query, rays);
            float& first = answers[rayWith(hits) * answerFloats(query)];
            first = first != 0.0F ? 0.0F : 1.0F;
            const Correctness correctness = judge(query, answers);
            EXPECT_EQ(correctness.wrong, 1U) << nameOf(query);
            EXPECT_EQ(correctness.gross, 0U) << nameOf(query);
            EXPECT_FALSE(correctness.right());
        }
    }
}

TEST_F(BenchCorrectness, CountsAPositionThatIsOff) {
    for (const auto& [query, x] : {std::pair(Query::Nearest, 2U), std::pair(Query::All, 5U + 3U)}) {
        std::vector<float> answers = exactAnswers(query, rays);
        float& coordinate = answers[rayWith(2) * answerFloats(query) + x];
        const float exact = coordinate;
        coordinate = exact + 0.011F * ring.minorRadius;
        EXPECT_EQ(judge(query, answers).gross, 1U);
        EXPECT_EQ(judge(query, answers).wrong, 0U);
        EXPECT_FALSE(judge(query, answers).right());
        coordinate = exact + 0.009F * ring.minorRadius;
        EXPECT_EQ(judge(query, answers).gross, 0U);
        coordinate = nan;
        EXPECT_EQ(judge(query, answers).gross, 1U) << "NaN is off by more than anything";
    }
}

TEST_F(BenchCorrectness, CountsHitsOutOfOrderAndNaN) {
    std::vector<float> answers = exactAnswers(Query::All, rays);
    const std::size_t at = rayWith(2) * answerFloats(Query::All);
    std::swap(answers[at + 1], answers[at + 2]);
    EXPECT_EQ(judge(Query::All, answers).wrong, 1U);
    std::swap(answers[at + 1], answers[at + 2]);
    EXPECT_EQ(judge(Query::All, answers).wrong, 0U);
    answers[at + 2] = nan;
    EXPECT_EQ(judge(Query::All, answers).wrong, 1U);

    std::vector<float> nearest = exactAnswers(Query::Nearest, rays);
    nearest[rayWith(2) * answerFloats(Query::Nearest) + 1] = nan;
    EXPECT_EQ(judge(Query::Nearest, nearest).wrong, 1U);
}

TEST_F(BenchCorrectness, CountsAHitTooFew) {
    std::vector<float> answers = exactAnswers(Query::All, rays);
    answers[rayWith(2) * answerFloats(Query::All)] -= 1.0F;
    EXPECT_EQ(judge(Query::All, answers).wrong, 1U);
}

}  // namespace
}  // namespace raytorus::bench
