// SPDX-License-Identifier: MIT
// Denormal numbers in every input, with denormals kept and with denormals flushed to zero as many GPUs do.
// Flushing must change nothing for a ray that has none, and nothing may come out of one that has but a hit on
// the surface or a miss. A device that can be told to flush is rare; the library's GLSL compiled as C++ runs
// on a processor that can.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "hit_judge.hpp"
#include "support/device_fixture.hpp"
#include "support/flush_denormals.hpp"
#include "support/hit_match.hpp"
#include "support/special_floats.hpp"
#include "torus_cxx.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus {
namespace {

using reference::Ray;
using reference::RayClass;
using reference::Torus;

constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float largestDenormal = 0x1.fffffcp-127F;

judge::Answers twin(const Torus& torus, const Ray& given) {
    const trace::TraceRay ray = trace::asTraceRay(given);
    return {test::cxxNearest(torus.majorRadius, torus.minorRadius, ray),
            test::cxxAll(torus.majorRadius, torus.minorRadius, ray),
            test::cxxAny(torus.majorRadius, torus.minorRadius, ray)};
}

judge::Answers flushedTwin(const Torus& torus, const Ray& ray) {
    const test::FlushDenormals flush;
    return twin(torus, ray);
}

bool isDenormal(float x) {
    return std::fpclassify(x) == FP_SUBNORMAL;
}

struct Input {
    Torus torus;
    Ray ray;
};

// Every number of several rays in turn, and pairs of them, replaced by denormals of either sign.
std::vector<Input> denormalInputs() {
    std::vector<Input> inputs;
    const Ray across{{3, 0, 0}, 0, {-1, 0, 0}, infinity};
    const Ray oblique{{2.5F, -1, 0.5F}, 0, {-1, 0.25F, -0.125F}, 100};
    const Ray within{{1, 0, 0}, -0.125F, {0, 0, 1}, 5};
    const Ray downwards{{0.875F, 0.25F, 3}, 0, {0, 0, -1}, infinity};
    for (const Ray& ray : {across, oblique, within, downwards}) {
        for (const float minorRadius : {0.25F, 1.0F, 1.25F}) {
            for (int first = 0; first < 10; ++first) {
                for (int second = first; second < 10; ++second) {
                    for (const float denormal : {smallest, -smallest, 1e-40F, -largestDenormal}) {
                        Input input{{1, minorRadius}, ray};
                        float* const numbers[10] = {&input.torus.majorRadius, &input.torus.minorRadius,
                                                    &input.ray.origin[0],     &input.ray.origin[1],
                                                    &input.ray.origin[2],     &input.ray.tMin,
                                                    &input.ray.direction[0],  &input.ray.direction[1],
                                                    &input.ray.direction[2],  &input.ray.tMax};
                        *numbers[first] = denormal;
                        *numbers[second] = denormal;
                        inputs.push_back(input);
                    }
                }
            }
        }
    }
    return inputs;
}

// The reference knows no smallest size and no flushing, so it is asked where neither matters. Not: a
// direction too short for the contract, which is a miss; a denormal or negative R or r, which may count as it
// is or as zero.
bool isForTheReference(const Input& input) {
    return input.torus.majorRadius >= 0 && input.torus.minorRadius > largestDenormal;
}

bool hasDirection(const Ray& ray) {
    return std::max({std::abs(ray.direction[0]), std::abs(ray.direction[1]), std::abs(ray.direction[2])}) >
           1e-18F;
}

std::string fault(Input input, judge::Answers answers) {
    if (!hasDirection(input.ray)) {
        return answers.all.count == 0.0F && answers.nearest.hit == 0.0F && answers.any == 0.0F ? "" : "a hit";
    }
    return isForTheReference(input) ? test::mismatch(input.torus, input.ray, answers)
                                    : test::malformed(input.ray, answers);
}

// Where denormals are flushed, an end of the ray that is one is as good as 0.
std::string flushedFault(Input input, judge::Answers answers) {
    std::string found = fault(input, answers);
    for (float* end : {&input.ray.tMin, &input.ray.tMax}) {
        if (!found.empty() && isDenormal(*end)) {
            *end = 0.0F;
            for (float& t : answers.all.t) {
                t = isDenormal(t) ? 0.0F : t;
            }
            answers.nearest.t = isDenormal(answers.nearest.t) ? 0.0F : answers.nearest.t;
            found = fault(input, answers);
        }
    }
    return found;
}

void expectNoFaults(const std::vector<Input>& inputs, const std::vector<judge::Answers>& answers,
                    std::string (*faultOf)(Input, judge::Answers)) {
    int faults = 0;
    int hits = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        hits += answers[i].any != 0.0F ? 1 : 0;
        const std::string found = faultOf(inputs[i], answers[i]);
        if (!found.empty() && ++faults <= 5) {
            ADD_FAILURE() << found << "\n  " << reference::hexFloats(inputs[i].torus, inputs[i].ray);
        }
    }
    EXPECT_EQ(faults, 0) << "of " << inputs.size();
    EXPECT_GT(hits, static_cast<int>(inputs.size() / 4));
}

using Denormals = test::DeviceTest;

TEST_F(Denormals, AreRightOnTheDevice) {
    const std::vector<Input> inputs = denormalInputs();
    test::HitJudge judge(1);
    int faults = 0;
    for (const Input& input : inputs) {
        if (hasDirection(input.ray) && isForTheReference(input)) {
            const std::string found = judge.mismatches(input.torus, {input.ray}).front();
            if (!found.empty() && ++faults <= 5) {
                ADD_FAILURE() << found;
            }
        }
    }
    EXPECT_EQ(faults, 0);
}

TEST_F(Denormals, AreRightWhereTheyAreKept) {
    const std::vector<Input> inputs = denormalInputs();
    std::vector<judge::Answers> answers;
    for (const Input& input : inputs) {
        answers.push_back(twin(input.torus, input.ray));
    }
    expectNoFaults(inputs, answers, fault);
}

TEST_F(Denormals, AreRightWhereTheyAreFlushed) {
    const std::vector<Input> inputs = denormalInputs();
    std::vector<judge::Answers> answers;
    for (const Input& input : inputs) {
        answers.push_back(flushedTwin(input.torus, input.ray));
    }
    expectNoFaults(inputs, answers, flushedFault);
    // The mode is on where it is meant to be, and off again.
    volatile float denormal = 1e-40F;
    EXPECT_NE(denormal * 1.0F, 0.0F);
    const test::FlushDenormals flush;
    EXPECT_EQ(denormal * 1.0F, 0.0F);
}

// Sizes to 1e-15 and directions to 1e-18, so that the products of the smallest parts would be denormal
// unscaled.
TEST_F(Denormals, FlushingChangesNoBitOfOtherRays) {
    int hits = 0;
    for (const float size : {1.0F, 0x1p-50F, 0x1p50F}) {
        for (const float speed : {1.0F, 0x1p-59F, 0x1p59F}) {
            for (const float minorRadius : {1e-3F, 0.25F, 1.0F, 1.5F}) {
                for (const RayClass rayClass : reference::allRayClasses) {
                    reference::RayParameters parameters;
                    parameters.torus = {1, minorRadius};
                    parameters.distance = 10;
                    parameters.seed = 8;
                    const auto rays = reference::generateRays(
                        rayClass == RayClass::nonUnit ? RayClass::camera : rayClass, parameters, 50);
                    for (Ray ray : rays) {
                        bool normal = true;  // all that goes in and comes out
                        for (int i = 0; i < 3; ++i) {
                            ray.origin[i] *= size;
                            ray.direction[i] *= speed;
                            normal = normal && !isDenormal(ray.origin[i]) && !isDenormal(ray.direction[i]);
                        }
                        ray.tMin *= size / speed;
                        ray.tMax = std::min(ray.tMax, 1e3F) * (size / speed);
                        normal = normal && !isDenormal(ray.tMin);
                        const Torus torus{size, minorRadius * size};
                        const judge::Answers kept = twin(torus, ray), flushed = flushedTwin(torus, ray);
                        // A result that is denormal itself is what flushing is for.
                        for (const float t : kept.all.t) {
                            normal = normal && !isDenormal(t);
                        }
                        for (const auto& position : kept.all.position) {
                            for (const float x : position) {
                                normal = normal && !isDenormal(x);
                            }
                        }
                        bool same = kept.all.count == flushed.all.count && kept.any == flushed.any &&
                                    std::memcmp(kept.all.position, flushed.all.position,
                                                sizeof kept.all.position) == 0;
                        if (size / speed > 0x1p-78F) {
                            same = same && std::memcmp(kept.all.t, flushed.all.t, sizeof kept.all.t) == 0;
                        }
                        EXPECT_TRUE(same || !normal) << reference::hexFloats(torus, ray);
                        hits += normal && kept.any != 0.0F ? 1 : 0;
                    }
                }
            }
        }
    }
    EXPECT_GT(hits, 5000);
}

}  // namespace
}  // namespace raytorus
