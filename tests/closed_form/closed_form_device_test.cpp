// SPDX-License-Identifier: MIT
// The closed form on the device: the bits of the same text as C++, and nothing non-finite, whatever goes in.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "closed_form_probe.hpp"
#include "reference/random.hpp"
#include "reference/rays.hpp"
#include "support/device_fixture.hpp"
#include "support/fresh_seed.hpp"

namespace raytorus {
namespace {

using test::ClosedFormAnswer;
using test::ClosedFormQuery;

class ClosedFormDevice : public test::DeviceTest {};

std::array<float, 32> floats(const ClosedFormAnswer& answer) {
    return std::bit_cast<std::array<float, 32>>(answer);
}

std::vector<ClosedFormQuery> ordinaryRays(std::uint64_t each) {
    std::vector<ClosedFormQuery> queries;
    for (const float minorRadius : {0.001F, 0.01F, 0.1F, 0.5F, 1.0F, 1.5F}) {
        for (const reference::RayClass rayClass : reference::allRayClasses) {
            const reference::RayParameters parameters{{1.0F, minorRadius}, 3.0, 1e-4, test::freshSeed()};
            for (const reference::Ray& ray : generateRays(rayClass, parameters, each)) {
                ClosedFormQuery q{1.0F, minorRadius, {}, {}};
                std::copy(ray.origin, ray.origin + 3, q.origin);
                std::copy(ray.direction, ray.direction + 3, q.direction);
                queries.push_back(q);
            }
        }
    }
    return queries;
}

// Denormals are the driver's to flush, and with them what is the square root of one, 1e-19 R; and of zeros of
// different sign min and max may return either.
float flushed(float x) {
    return std::abs(x) < 0x1p-60F ? 0.0F : x;
}

TEST_F(ClosedFormDevice, HasTheBitsOfTheSameTextAsCxx) {
    const std::vector<ClosedFormQuery> queries = ordinaryRays(100);
    const std::vector<ClosedFormAnswer> answers = answersOfDevice(queries);
    std::size_t met = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const std::array<float, 32> found = floats(answers[i]);
        const std::array<float, 32> expected = floats(test::answerOfCxx(queries[i]));
        met += answers[i].t.count > 0 ? 1U : 0U;
        for (std::size_t k = 0; k < 32; ++k) {
            ASSERT_EQ(flushed(found[k]), flushed(expected[k])) << "ray " << i << ", float " << k;
        }
    }
    EXPECT_GT(met, queries.size() / 3);
}

// Any finite float, and numbers where squares, cubes or sixth powers leave float32.
float wild(reference::Random& random) {
    switch (random.below(4)) {
        case 0: {
            float value;
            do {
                const std::uint64_t bits = random.next() >> 32;
                const auto word = static_cast<std::uint32_t>(bits);
                std::memcpy(&value, &word, sizeof value);
            } while (!std::isfinite(value));
            return value;
        }
        case 1:
            return static_cast<float>(random.sign() * std::ldexp(1.0, random.below(254) - 126));
        case 2:
            return static_cast<float>(random.sign() *
                                      std::ldexp(random.uniform(1, 2), random.below(40) - 20));
        default:
            return static_cast<float>(random.sign() * random.below(3));
    }
}

TEST_F(ClosedFormDevice, GivesFiniteNumbersForAnyFiniteRay) {
    std::vector<ClosedFormQuery> queries;
    for (std::uint64_t i = 0; i < 100000; ++i) {
        reference::Random random(test::freshSeed(), 1, i);
        ClosedFormQuery q{};
        // Half of them about as large as the torus, so that there is something to solve.
        q.majorRadius = i % 2 == 0 ? wild(random) : 1.0F;
        q.minorRadius = i % 2 == 0 ? wild(random) : std::abs(wild(random));
        for (float& x : q.origin) {
            x = wild(random);
        }
        for (float& x : q.direction) {
            x = wild(random);
        }
        queries.push_back(q);
    }
    // Met where t is beyond float32: a miss, as for the library.
    queries.push_back({1e17F, 2.5e16F, {-1e22F, 0, 0}, {1e-18F, 0, 0}});
    const std::vector<ClosedFormAnswer> answers = answersOfDevice(queries);
    std::size_t met = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const ClosedFormAnswer& a = answers[i];
        met += a.t.count > 0 ? 1U : 0U;
        for (const float x : floats(a)) {
            ASSERT_TRUE(std::isfinite(x))
                << i << ": " << queries[i].majorRadius << ' ' << queries[i].minorRadius;
        }
        for (const test::RootsAnswer& roots : {a.t, a.axial, a.radial}) {
            const auto count = static_cast<std::size_t>(roots.count);
            ASSERT_TRUE(count == 0 || count == 2 || count == 4);
            ASSERT_TRUE(std::is_sorted(roots.roots, roots.roots + count)) << i;
            for (std::size_t k = count; k < 4; ++k) {
                ASSERT_EQ(roots.roots[k], 0.0F);
            }
        }
    }
    EXPECT_GT(met, 1000U);
}

TEST_F(ClosedFormDevice, HasNoRootsForBadInput) {
    const ClosedFormQuery good{1.0F, 0.25F, {-3, 0, 0}, {1, 0, 0}};
    std::vector<ClosedFormQuery> queries{good};
    const auto with = [&](auto change) {
        queries.push_back(good);
        change(queries.back());
    };
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY}) {
        with([&](ClosedFormQuery& q) { q.majorRadius = bad; });
        with([&](ClosedFormQuery& q) { q.minorRadius = bad; });
        with([&](ClosedFormQuery& q) { q.origin[1] = bad; });
        with([&](ClosedFormQuery& q) { q.direction[1] = bad; });
    }
    with([](ClosedFormQuery& q) { q.majorRadius = 0; });
    with([](ClosedFormQuery& q) { q.majorRadius = -1; });
    with([](ClosedFormQuery& q) { q.minorRadius = 0; });
    with([](ClosedFormQuery& q) { q.minorRadius = 101; });
    with([](ClosedFormQuery& q) { q.direction[0] = 0; });
    const std::vector<ClosedFormAnswer> answers = answersOfDevice(queries);
    EXPECT_EQ(answers[0].t.count, 4.0F);
    for (std::size_t i = 1; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i].meets, 0.0F) << i;
        EXPECT_EQ(answers[i].t.count, 0.0F) << i;
        for (const float x : floats(answers[i])) {
            EXPECT_TRUE(std::isfinite(x)) << i;
        }
    }
}

}  // namespace
}  // namespace raytorus
