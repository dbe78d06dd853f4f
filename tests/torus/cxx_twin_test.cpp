// SPDX-License-Identifier: MIT
// The library's GLSL, compiled as C++, answers everything with the bits of the SPIR-V: a user can run the
// very same code on the CPU, and any two drivers that pass here have the same bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "reference/random.hpp"
#include "reference/rays.hpp"
#include "support/device_fixture.hpp"
#include "support/flush_denormals.hpp"
#include "support/fresh_seed.hpp"
#include "support/special_floats.hpp"
#include "torus_cxx.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus {
namespace {

using reference::RayClass;
using reference::Torus;
using trace::Query;
using trace::TraceRay;

constexpr std::array minorRadii = {0.001F, 0.01F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};

// Of each class, radius and distance, and as many again with small components: 72 000 rays.
constexpr std::uint64_t raysEach = 60;

// Of random numbers, so that no two uses have the same.
constexpr std::uint64_t rayStream = 2300, pointStream = 2301, squareStream = 2302;

struct Case {
    std::string name;
    Torus torus;
    std::vector<TraceRay> rays;
};

// Some components down to 10^-15 of what they were: their products are tiny, and where a driver flushes
// denormals, some of them 0.
void shrinkComponents(TraceRay& ray, reference::Random& random) {
    for (float& component : std::span(ray.origin)) {
        component *= static_cast<float>(std::pow(10.0, std::min(random.uniform(-15, 15), 0.0)));
    }
    for (float& component : std::span(ray.direction)) {
        component *= static_cast<float>(std::pow(10.0, std::min(random.uniform(-15, 15), 0.0)));
    }
}

// Starts on the surface and ends there, with zeros of both signs wherever one can be.
std::vector<TraceRay> raysOfZeros() {
    std::vector<TraceRay> rays;
    for (const float zero : {0.0F, -0.0F}) {
        for (const float axis : {1.0F, -1.0F}) {
            for (const float tMin : {zero, -zero, -1.0F, -infinity}) {
                for (const float tMax : {infinity, 0.5F, zero, -zero}) {
                    for (const float x : {1.25F, 0.75F, 1.0F, zero}) {
                        rays.push_back({{x, zero, 0.0F}, tMin, {axis, 0.0F, zero}, tMax});
                        rays.push_back({{zero, x, -zero}, tMin, {zero, axis, 0.0F}, tMax});
                        rays.push_back({{x, zero, 0.25F}, tMin, {zero, -zero, axis}, tMax});
                    }
                }
            }
        }
    }
    return rays;
}

std::vector<Case> cases() {
    std::vector<Case> list;
    reference::Random random(test::freshSeed(), rayStream, 0);
    for (const float minorRadius : minorRadii) {
        for (const double distance : {1.5, 3.0, 100.0, 1e4, 1e6}) {
            for (const RayClass rayClass : reference::allRayClasses) {
                // A ray aimed at a horn's tip may be 1e-12 r from a tangent there and hit 1e-12 R beside it:
                // whether denormals are flushed decides then (docs/testing.md).
                const bool atAxis = rayClass == RayClass::throughCentre || rayClass == RayClass::throughAxis;
                if (minorRadius == 1.0F && atAxis) {
                    continue;
                }
                reference::RayParameters parameters;
                parameters.torus = {1.0F, minorRadius};
                parameters.distance = distance;
                parameters.seed = test::freshSeed();
                std::vector<TraceRay> rays =
                    trace::asTraceRays(reference::generateRays(rayClass, parameters, raysEach));
                const std::string name = reference::nameOf(rayClass);
                list.push_back({name, parameters.torus, rays});
                // Not of a horn: what is tiny beside its tip decides whether a ray meets it.
                if (minorRadius != 1.0F) {
                    for (TraceRay& ray : rays) {
                        shrinkComponents(ray, random);
                    }
                    list.push_back({name + ", components shrunk", parameters.torus, rays});
                }
            }
        }
    }
    list.push_back({"zeros", {1.0F, 0.25F}, raysOfZeros()});
    return list;
}

// Points on the surface, near it, and anywhere up to a million R away, with uv of several turns; and points
// on the axis, the equator and the centre circle, where functions have their special cases.
std::vector<test::SurfacePoint> surfacePoints() {
    std::vector<test::SurfacePoint> points;
    reference::Random random(test::freshSeed(), pointStream, 0);
    for (const float minorRadius : minorRadii) {
        const auto add = [&points, minorRadius](double x, double y, double z, double u, double v) {
            points.push_back({1.0F,
                              minorRadius,
                              {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)},
                              {static_cast<float>(u), static_cast<float>(v)}});
        };
        for (int i = 0; i < 3000; ++i) {
            const double u = random.uniform(-3, 3);
            const double v = random.uniform(-3, 3);
            const double off = i % 2 == 0 ? 1.0 : 1.0 + std::pow(10.0, random.uniform(-7, 0));
            const double r = static_cast<double>(minorRadius) * off;
            const double rho = 1.0 + r * std::cos(2 * M_PI * v);
            add(rho * std::cos(2 * M_PI * u), rho * std::sin(2 * M_PI * u), r * std::sin(2 * M_PI * v), u, v);
            const double size = std::pow(10.0, random.uniform(-6, 6));
            add(size * random.uniform(-1, 1), size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                1000 * u, v / 1000);
        }
        for (const double x : {0.0, -0.0, 1.0, -1.0, 0.25, -1.25}) {
            for (const double y : {0.0, -0.0, 1.0, -1e-8, 1e-18}) {
                for (const double z : {0.0, -0.0, 0.25, -1e-8}) {
                    add(x, y, z, x, z);
                }
            }
        }
    }
    return points;
}

// The floats whose bits differ, named; empty if all are the same.
template <typename Answer>
std::string difference(const Answer& ours, const void* theirs) {
    std::array<float, sizeof(Answer) / sizeof(float)> a{};
    std::array<float, sizeof(Answer) / sizeof(float)> b{};
    std::memcpy(a.data(), &ours, sizeof(Answer));
    std::memcpy(b.data(), theirs, sizeof(Answer));
    std::string text;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0) {
            text += fmt::format(" [{}] {:a} and {:a}", i, a[i], b[i]);
        }
    }
    return text;
}

// The first few differences in full, the others counted.
class Differences {
public:
    void add(const std::string& text) {
        if (!text.empty() && ++count <= 5) {
            ADD_FAILURE() << text;
        }
    }
    ~Differences() { EXPECT_EQ(count, 0U) << "answers differ"; }

private:
    std::size_t count = 0;
};

std::string described(const Case& c, const TraceRay& ray, const std::string& difference) {
    return difference.empty()
               ? ""
               : fmt::format("{}: {} differs:{}", c.name,
                             reference::hexFloats(c.torus, trace::asReferenceRay(ray)), difference);
}

// Asks one query of every ray, both ways, and returns how many answers were hits (or counts above 0).
template <typename Answer, typename OnCpu>
std::size_t expectSameBits(Query query, OnCpu onCpu) {
    static_assert(sizeof(Answer) % sizeof(float) == 0);
    trace::Tracer tracer(test::device(), query, 1000);
    std::size_t hits = 0;
    Differences differences;
    for (const Case& c : cases()) {
        const auto [majorRadius, minorRadius] = c.torus;
        const std::span<const float> answers = tracer.trace(c.torus, c.rays);
        for (std::size_t i = 0; i < c.rays.size(); ++i) {
            const Answer cpu = onCpu(majorRadius, minorRadius, c.rays[i]);
            const float* gpu = answers.data() + i * sizeof(Answer) / sizeof(float);
            hits += *gpu > 0.0F ? 1 : 0;
            differences.add(described(c, c.rays[i], difference(cpu, gpu)));
        }
    }
    return hits;
}

using CxxTwin = test::DeviceTest;

TEST_F(CxxTwin, NearestHitHasTheSameBits) {
    EXPECT_GT(expectSameBits<trace::NearestHit>(Query::Nearest, test::cxxNearest), 15000U);
}

TEST_F(CxxTwin, AllHitsHaveTheSameBits) {
    EXPECT_GT(expectSameBits<trace::AllHits>(Query::All, test::cxxAll), 15000U);
}

TEST_F(CxxTwin, AnyHitIsTheSame) {
    EXPECT_GT(expectSameBits<float>(Query::Any, test::cxxAny), 15000U);
}

std::string described(const test::SurfacePoint& at, const std::string& difference) {
    const auto& [x, y, z] = at.point;
    return difference.empty() ? ""
                              : fmt::format("r/R {:a}, point {:a} {:a} {:a}, uv {:a} {:a} differs:{}",
                                            at.minorRadius, x, y, z, at.uv[0], at.uv[1], difference);
}

TEST_F(CxxTwin, SurfaceFunctionsHaveTheSameBits) {
    const std::vector<test::SurfacePoint> points = surfacePoints();
    const std::vector<test::SurfaceAnswer> answers = test::SurfaceProbe(test::device()).ask(points);
    Differences differences;
    for (std::size_t i = 0; i < points.size(); ++i) {
        differences.add(described(points[i], difference(test::cxxSurface(points[i]), &answers[i])));
    }
}

#ifdef __SSE__
// Vulkan leaves denormals to the driver. The same code with and without them, whatever the driver here does.
TEST(CxxTwinAlone, FlushingDenormalsChangesNoBit) {
    {
        volatile float smallest = std::numeric_limits<float>::min();
        const test::FlushDenormals flushed;
        ASSERT_EQ(smallest * 0.5F, 0.0F) << "denormals are not flushed";
    }
    Differences differences;
    for (const Case& c : cases()) {
        const auto [majorRadius, minorRadius] = c.torus;
        for (const TraceRay& ray : c.rays) {
            const trace::NearestHit nearest = test::cxxNearest(majorRadius, minorRadius, ray);
            const trace::AllHits all = test::cxxAll(majorRadius, minorRadius, ray);
            const float any = test::cxxAny(majorRadius, minorRadius, ray);
            const test::FlushDenormals flushed;
            const trace::NearestHit flushedNearest = test::cxxNearest(majorRadius, minorRadius, ray);
            const trace::AllHits flushedAll = test::cxxAll(majorRadius, minorRadius, ray);
            const float flushedAny = test::cxxAny(majorRadius, minorRadius, ray);
            differences.add(described(c, ray,
                                      difference(nearest, &flushedNearest) + difference(all, &flushedAll) +
                                          difference(any, &flushedAny)));
        }
    }
    for (const test::SurfacePoint& point : surfacePoints()) {
        const test::SurfaceAnswer kept = test::cxxSurface(point);
        const test::FlushDenormals flushed;
        const test::SurfaceAnswer answer = test::cxxSurface(point);
        differences.add(described(point, difference(kept, &answer)));
    }
}
#endif

// What a product's rounding took is a float, and found: by its halves, and by an fma() that rounds once.
TEST(CxxTwinAlone, ProductErrorIsExact) {
    std::mt19937 random(static_cast<unsigned>(test::freshSeed()));
    std::uniform_real_distribution<float> part(-2.0F, 2.0F);
    for (int i = 0; i < 200000; ++i) {
        // Far enough from underflow for the product of the low halves.
        const float a = std::ldexp(part(random), i % 61 - 30);
        const float b = std::ldexp(part(random), i % 59 - 29);
        const double exact = static_cast<double>(a) * static_cast<double>(b) - static_cast<double>(a * b);
        ASSERT_EQ(static_cast<double>(test::cxxProductError(a, b)), exact) << fmt::format("{:a} {:a}", a, b);
        ASSERT_EQ(static_cast<double>(test::cxxProductErrorFused(a, b)), exact)
            << fmt::format("{:a} {:a}", a, b);
    }
}

// All hits, which begin with the nearest, whose number is what any-hit asks. Where components are shrunk, low
// halves underflow, and what is left of them is not the same.
TEST(CxxTwinAlone, AFusedFmaChangesNoBit) {
    std::size_t hits = 0;
    Differences differences;
    for (const Case& c : cases()) {
        if (c.name.ends_with("shrunk")) {
            continue;
        }
        for (const TraceRay& ray : c.rays) {
            const auto plain = test::cxxAll(c.torus.majorRadius, c.torus.minorRadius, ray);
            const auto fused = test::cxxAllFused(c.torus.majorRadius, c.torus.minorRadius, ray);
            hits += plain.count > 0.0F ? 1 : 0;
            differences.add(described(c, ray, difference(plain, &fused)));
        }
    }
    EXPECT_GT(hits, 8000U);
}

// a^2 + b^2 - c^2 is right to 2^-45 c^2 wherever the first two nearly make up the third: also where both are
// just below half of it, and no difference of two of them is exact.
TEST(CxxTwinAlone, SquareDifferenceKeepsWhatCancels) {
    reference::Random random(test::freshSeed(), squareStream, 0);
    const auto off = [&random] { return random.uniform(-1e-6, 1e-6); };
    for (int i = 0; i < 200000; ++i) {
        const double angle = i % 2 == 0 ? random.uniform(0, M_PI / 2) : M_PI / 4 + off();
        // Half of c^2 near a power of two: what is just below has one more digit than what is just above.
        const auto c = static_cast<float>(i % 4 == 3 ? 1 + off() : random.uniform(1, 2));
        const auto a = static_cast<float>(static_cast<double>(c) * std::cos(angle) * (1 + off()));
        const auto b = static_cast<float>(static_cast<double>(c) * std::sin(angle) * (1 + off()));
        const auto square = [](float x) { return static_cast<double>(x) * static_cast<double>(x); };
        // Squares of floats are doubles without rounding; so is the difference of two that are within a
        // factor of 2.
        const double larger = std::max(square(a), square(b)) - square(c);
        const double exact = larger + std::min(square(a), square(b));
        const double found = static_cast<double>(test::cxxSquareDifference(a, b, c));
        // The result's own rounding, and some roundings of what the squares' roundings add up to.
        ASSERT_NEAR(found, exact, std::abs(exact) * 0x1p-23 + square(c) * 0x1p-45)
            << fmt::format("{:a} {:a} {:a}", a, b, c);
    }
}

}  // namespace
}  // namespace raytorus
