// SPDX-License-Identifier: MIT
// What the include promises whatever it is given: bad input is a miss with everything written and nothing
// non-finite, and a change of scale by powers of two changes no bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "device_fixture.hpp"
#include "reference/rays.hpp"
#include "render/tracer.hpp"
#include "verify/trace_ray.hpp"

namespace raytorus {
namespace {

using render::Query;
using render::TraceRay;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();
constexpr std::size_t cameraRayCount = 512;

struct BadInput {
    std::string name;
    float majorRadius = 1.0F;
    float minorRadius = 0.25F;
    TraceRay ray{{3, 0, 0}, 0, {-1, 0, 0}, 100};
    float t = 100;  // of every entry of the answer
};

std::vector<BadInput> badInputs() {
    std::vector<BadInput> list;
    const auto add = [&list](const std::string& name, auto change) {
        list.push_back({name});
        change(list.back());
    };
    for (const float bad : {nan, infinity, -infinity}) {
        add(fmt::format("majorRadius {}", bad), [bad](BadInput& b) { b.majorRadius = bad; });
        add(fmt::format("minorRadius {}", bad), [bad](BadInput& b) { b.minorRadius = bad; });
        for (int i = 0; i < 3; ++i) {
            add(fmt::format("origin[{}] {}", i, bad), [=](BadInput& b) { b.ray.origin[i] = bad; });
            add(fmt::format("direction[{}] {}", i, bad), [=](BadInput& b) { b.ray.direction[i] = bad; });
        }
    }
    add("minorRadius 0", [](BadInput& b) { b.minorRadius = 0; });
    add("minorRadius -0.25", [](BadInput& b) { b.minorRadius = -0.25F; });
    add("majorRadius -1", [](BadInput& b) { b.majorRadius = -1; });
    add("direction 0", [](BadInput& b) { b.ray.direction[0] = 0; });
    add("direction -0", [](BadInput& b) { b.ray.direction[0] = -0.0F; });
    add("tMin > tMax", [](BadInput& b) { b.ray.tMin = 101; });
    add("tMin nan", [](BadInput& b) { b.ray.tMin = nan; });
    add("tMin inf", [](BadInput& b) { b.ray.tMin = infinity; });
    add("tMin nan and tMax nan", [](BadInput& b) { b.ray.tMin = b.ray.tMax = nan, b.t = 0; });
    add("tMax nan", [](BadInput& b) { b.ray.tMax = nan, b.t = 0; });
    add("tMax -inf", [](BadInput& b) { b.ray.tMax = -infinity, b.t = 0; });
    add("tMax -largest", [](BadInput& b) { b.ray.tMax = b.t = -largest; });
    add("minorRadius -0", [](BadInput& b) { b.minorRadius = -0.0F; });
    add("minorRadius negative denormal", [](BadInput& b) { b.minorRadius = -1e-40F; });
    add("both radii infinite", [](BadInput& b) { b.majorRadius = b.minorRadius = infinity; });
    add("radii whose sum overflows", [](BadInput& b) { b.majorRadius = b.minorRadius = 0.75F * largest; });
    add("radii that cancel", [](BadInput& b) { b.majorRadius = -1, b.minorRadius = 1.25F; });
    add("origin and direction infinite",
        [](BadInput& b) { b.ray.origin[0] = -(b.ray.direction[0] = infinity); });
    add("everything nan", [](BadInput& b) {
        b = {b.name, nan, nan, {{nan, nan, nan}, nan, {nan, nan, nan}, nan}, 0};
    });
    add("everything 0", [](BadInput& b) { b = {b.name, 0, 0, {{0, 0, 0}, 0, {0, 0, 0}, 0}, 0}; });
    add("denormal torus", [](BadInput& b) { b.majorRadius = b.minorRadius = 1e-40F; });
    add("denormal direction", [](BadInput& b) { b.ray.direction[0] = -1e-40F; });
    add("huge torus", [](BadInput& b) { b.majorRadius = b.minorRadius = largest; });
    add("huge direction", [](BadInput& b) { b.ray.direction[0] = -largest; });
    add("origin beyond", [](BadInput& b) { b.ray.origin[1] = largest; });
    return list;
}

// A tracer a question, kept: each makes a pipeline, which takes some drivers a third of a second.
class Contract : public test::DeviceTest {
protected:
    std::vector<float> trace(Query query, float majorRadius, float minorRadius,
                             const std::vector<TraceRay>& rays) {
        std::optional<render::Tracer>& tracer = tracers.at(static_cast<std::size_t>(query));
        if (!tracer) {
            tracer.emplace(test::device(), query, cameraRayCount);
        }
        const std::span<const float> values = tracer->trace(majorRadius, minorRadius, rays);
        return {values.begin(), values.end()};
    }

private:
    std::array<std::optional<render::Tracer>, 3> tracers;
};

TEST_F(Contract, BadInputIsAMissWithEveryOutputWritten) {
    const auto traceBad = [this](Query query, const BadInput& bad) {
        // The unspoilt ray's answer lies where the bad one's belongs: what is not written is not as expected.
        trace(query, 1.0F, 0.25F, {BadInput{}.ray});
        return trace(query, bad.majorRadius, bad.minorRadius, {bad.ray});
    };
    for (const BadInput& bad : badInputs()) {
        EXPECT_EQ(traceBad(Query::Nearest, bad), (std::vector<float>{0, bad.t, 0, 0, 0, 0, 0, 0}))
            << bad.name;
        std::vector<float> none(17, 0.0F);
        std::fill(none.begin() + 1, none.begin() + 5, bad.t);
        EXPECT_EQ(traceBad(Query::All, bad), none) << bad.name;
        EXPECT_EQ(traceBad(Query::Any, bad), std::vector<float>{0}) << bad.name;
    }
    // The unspoilt ray hits: the misses above are not for another reason.
    EXPECT_EQ(trace(Query::Any, 1.0F, 0.25F, {BadInput{}.ray}), std::vector<float>{1});
}

TEST_F(Contract, TMaxMayBeInfiniteAndANanInItIsAMiss) {
    for (const float tMax : {infinity, largest}) {
        const TraceRay hits{{3, 0, 0}, 0, {-1, 0, 0}, tMax};
        const TraceRay misses{{3, 0, 0}, 0, {1, 0, 0}, tMax};
        const std::vector<float> found = trace(Query::Nearest, 1.0F, 0.25F, {hits});
        EXPECT_EQ(found[0], 1.0F);
        EXPECT_NEAR(found[1], 1.75F, 1e-6F);
        EXPECT_EQ(trace(Query::Nearest, 1.0F, 0.25F, {misses})[1], tMax);
    }
    const TraceRay bad{{3, 0, 0}, 0, {-1, 0, 0}, nan};
    EXPECT_EQ(trace(Query::Nearest, 1.0F, 0.25F, {bad}), (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0}));
    const TraceRay unbounded{{3, 0, 0}, -infinity, {-1, 0, 0}, infinity};
    EXPECT_EQ(trace(Query::All, 1.0F, 0.25F, {unbounded})[0], 4.0F);
}

std::vector<TraceRay> cameraRays(float minorRadius) {
    reference::RayParameters parameters;
    parameters.torus = {1.0F, minorRadius};
    return verify::asTraceRays(
        reference::generateRays(reference::RayClass::camera, parameters, cameraRayCount));
}

bool sameBits(float a, float b) {
    return std::memcmp(&a, &b, sizeof(float)) == 0;
}

TEST_F(Contract, ScalingByPowersOfTwoChangesNoBit) {
    const std::vector<TraceRay> rays = cameraRays(0.25F);
    const std::vector<float> unscaled = trace(Query::All, 1.0F, 0.25F, rays);
    for (const int exponent : {-40, -13, 1, 7, 40}) {
        for (const int directionExponent : {-30, 0, 17}) {
            std::vector<TraceRay> scaled = rays;
            for (TraceRay& ray : scaled) {
                for (int i = 0; i < 3; ++i) {
                    ray.origin[i] = std::ldexp(ray.origin[i], exponent);
                    ray.direction[i] = std::ldexp(ray.direction[i], directionExponent);
                }
                ray.tMin = std::ldexp(ray.tMin, exponent - directionExponent);
                ray.tMax = std::min(std::ldexp(ray.tMax, exponent - directionExponent), largest);
            }
            const std::vector<float> hits =
                trace(Query::All, std::ldexp(1.0F, exponent), std::ldexp(0.25F, exponent), scaled);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const float* expected = &unscaled[17 * i];
                const float* actual = &hits[17 * i];
                ASSERT_EQ(actual[0], expected[0]) << i;
                for (int k = 0; k < static_cast<int>(expected[0]); ++k) {
                    EXPECT_TRUE(
                        sameBits(actual[1 + k], std::ldexp(expected[1 + k], exponent - directionExponent)));
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_TRUE(
                            sameBits(actual[5 + 3 * k + c], std::ldexp(expected[5 + 3 * k + c], exponent)));
                    }
                }
            }
        }
    }
}

TEST_F(Contract, EntriesPastTheCountHoldTMax) {
    const std::vector<TraceRay> rays = cameraRays(0.5F);
    const std::vector<float> hits = trace(Query::All, 1.0F, 0.5F, rays);
    int partial = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const int count = static_cast<int>(hits[17 * i]);
        partial += count > 0 && count < 4 ? 1 : 0;
        for (int k = count; k < 4; ++k) {
            EXPECT_EQ(hits[17 * i + 1 + static_cast<std::size_t>(k)], rays[i].tMax);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(hits[17 * i + 5 + 3 * static_cast<std::size_t>(k) + c], 0.0F);
            }
        }
        for (int k = 1; k < count; ++k) {
            EXPECT_LE(hits[17 * i + static_cast<std::size_t>(k)],
                      hits[17 * i + 1 + static_cast<std::size_t>(k)]);
        }
    }
    EXPECT_GT(partial, 0) << "no ray had entries past its hits";
}

}  // namespace
}  // namespace raytorus
