// SPDX-License-Identifier: MIT
// The library's GLSL, compiled as C++, answers every ray with the bits of the SPIR-V: a user can run the very
// same code on the CPU.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "device_fixture.hpp"
#include "reference/rays.hpp"
#include "torus_cxx.hpp"

namespace raytorus {
namespace {

using reference::RayClass;
using render::Query;
using render::TraceRay;

constexpr std::uint64_t raysEach = 100;

struct Case {
    RayClass rayClass;
    reference::RayParameters parameters;
    std::vector<TraceRay> rays;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const float minorRadius : {0.01F, 0.25F, 0.9F, 1.5F}) {
        for (const double distance : {3.0, 1000.0}) {
            for (const RayClass rayClass : reference::allRayClasses) {
                reference::RayParameters parameters;
                parameters.torus = {1.0F, minorRadius};
                parameters.distance = distance;
                parameters.seed = 29;
                const auto generated = reference::generateRays(rayClass, parameters, raysEach);
                std::vector<TraceRay> rays(generated.size());
                std::memcpy(rays.data(), generated.data(), rays.size() * sizeof(TraceRay));
                list.push_back({rayClass, parameters, std::move(rays)});
            }
        }
    }
    return list;
}

// Asks one question of every ray, both ways, and returns how many answers were hits (or counts above 0).
template <typename Answer, typename OnCpu>
std::size_t expectSameBits(Query query, OnCpu onCpu) {
    static_assert(sizeof(Answer) % sizeof(float) == 0);
    render::Tracer tracer(test::device(), query, raysEach);
    std::size_t hits = 0;
    std::size_t faults = 0;
    for (const Case& c : cases()) {
        const auto [majorRadius, minorRadius] = c.parameters.torus;
        const std::span<const float> answers = tracer.trace(majorRadius, minorRadius, c.rays);
        for (std::size_t i = 0; i < c.rays.size(); ++i) {
            const Answer cpu = onCpu(majorRadius, minorRadius, c.rays[i]);
            const float* gpu = answers.data() + i * sizeof(Answer) / sizeof(float);
            hits += *gpu > 0.0F ? 1 : 0;
            if (std::memcmp(&cpu, gpu, sizeof(Answer)) != 0 && ++faults <= 5) {
                ADD_FAILURE() << reference::describeRay(c.rayClass, c.parameters, i);
            }
        }
    }
    EXPECT_EQ(faults, 0U);
    return hits;
}

using CxxTwin = test::DeviceTest;

TEST_F(CxxTwin, NearestHitHasTheSameBits) {
    EXPECT_GT(expectSameBits<render::NearestHit>(Query::Nearest, test::cxxNearest), 3000U);
}

TEST_F(CxxTwin, AllHitsHaveTheSameBits) {
    EXPECT_GT(expectSameBits<render::AllHits>(Query::All, test::cxxAll), 3000U);
}

TEST_F(CxxTwin, AnyHitIsTheSame) {
    EXPECT_GT(expectSameBits<float>(Query::Any, test::cxxAny), 3000U);
}

}  // namespace
}  // namespace raytorus
