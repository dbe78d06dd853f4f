// SPDX-License-Identifier: MIT
// Normal, uv, position, tangents, distance and implicit function, through the real SPIR-V, against the
// reference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "device_fixture.hpp"
#include "reference/torus_reference.hpp"
#include "surface_probe.hpp"

namespace raytorus {
namespace {

using reference::QuadVec3;
using test::probe;
using Point = test::SurfacePoint;
using Answer = test::SurfaceAnswer;

constexpr std::array radii = {0.01F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};

// Points of the surface by random uv, each also with that uv.
std::vector<Point> surfacePoints() {
    std::vector<Point> points;
    for (const float minorRadius : radii) {
        for (int i = 0; i < 500; ++i) {
            const float u = static_cast<float>(i % 50) / 50.0F + 0.0037F;
            const float v = static_cast<float>(i / 50) / 10.0F + 0.0173F;
            const reference::Torus torus{1.0F, minorRadius};
            const auto exact = reference::toDouble(reference::position(torus, {u, v}));
            // On the inner sheet of a spindle, which is not part of the surface, uv means another point.
            if (1.0 + static_cast<double>(minorRadius) * std::cos(2 * M_PI * static_cast<double>(v)) < 0.0) {
                continue;
            }
            points.push_back(
                {1.0F,
                 minorRadius,
                 {static_cast<float>(exact[0]), static_cast<float>(exact[1]), static_cast<float>(exact[2])},
                 {u, v}});
        }
    }
    return points;
}

reference::Torus torusOf(const Point& point) {
    return {point.majorRadius, point.minorRadius};
}

double difference(const QuadVec3& exact, const float (&actual)[3]) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(reference::toDouble(exact[i] - actual[i])));
    }
    return worst;
}

double turnsBetween(double a, double b) {
    const double d = std::abs(a - b);
    return std::min(d, 1.0 - d);
}

// rho carries half an ulp of R, which turns the tube's radius by 2^-24 R / r.
double tubeRounding(const Point& point) {
    return 2.4e-7 * (1.0 + static_cast<double>(point.majorRadius) / static_cast<double>(point.minorRadius));
}

using Surface = test::DeviceTest;

TEST_F(Surface, NormalsAreUnitAndOutward) {
    const std::vector<Point> points = surfacePoints();
    const std::vector<Answer> answers = probe(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float(&n)[3] = answers[i].normal;
        EXPECT_LE(difference(reference::normal(torusOf(points[i]), reference::toQuad(points[i].point)), n),
                  tubeRounding(points[i]));
        EXPECT_NEAR(std::hypot(double(n[0]), double(n[1]), double(n[2])), 1.0, 2.4e-7);  // 2^-22
    }
}

TEST_F(Surface, UvIsRight) {
    const std::vector<Point> points = surfacePoints();
    const std::vector<Answer> answers = probe(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const reference::QuadVec2 exact =
            reference::uv(torusOf(points[i]), reference::toQuad(points[i].point));
        // The polynomial's 2.2e-9 and half an ulp of 1.
        EXPECT_LE(turnsBetween(reference::toDouble(exact[0]), double(answers[i].uv[0])), 1e-7);
        EXPECT_LE(turnsBetween(reference::toDouble(exact[1]), double(answers[i].uv[1])),
                  1e-7 + tubeRounding(points[i]) / 6);
        for (const float value : answers[i].uv) {
            EXPECT_GE(value, 0.0F);
            EXPECT_LT(value, 1.0F);
        }
    }
}

TEST_F(Surface, UvAtTheSeamsIsInRange) {
    // On the axes of both circles, and an ulp below the seams, where 1 - tiny rounds to 1.
    std::vector<Point> points;
    for (const float y : {0.0F, -0.0F, -1e-30F, 1e-30F, -1e-8F}) {
        for (const float x : {1.25F, -1.25F, 0.75F}) {
            points.push_back({1.0F, 0.25F, {x, y, 0.0F}, {0, 0}});
            points.push_back({1.0F, 0.25F, {x, 0.0F, y}, {0, 0}});
            points.push_back({1.0F, 0.25F, {y, x, 0.0F}, {0, 0}});
        }
    }
    points.push_back({1.0F, 0.25F, {0, 0, 0}, {0, 0}});
    for (const Answer& answer : probe(points)) {
        for (const float value : answer.uv) {
            EXPECT_GE(value, 0.0F);
            EXPECT_LT(value, 1.0F);
        }
    }
    EXPECT_EQ(probe({{1.0F, 0.25F, {0, 1.25F, 0}, {0, 0}}})[0].uv[0], 0.25F);
    EXPECT_EQ(probe({{1.0F, 0.25F, {-1.25F, 0, 0}, {0, 0}}})[0].uv[0], 0.5F);
    EXPECT_EQ(probe({{1.0F, 0.25F, {0, -1.25F, 0}, {0, 0}}})[0].uv[0], 0.75F);
    EXPECT_EQ(probe({{1.0F, 0.25F, {1, 0, 0.25F}, {0, 0}}})[0].uv[1], 0.25F);
    EXPECT_EQ(probe({{1.0F, 0.25F, {0.75F, 0, 0}, {0, 0}}})[0].uv[1], 0.5F);
}

TEST_F(Surface, PositionsFollowTheEquation) {
    std::vector<Point> points = surfacePoints();
    for (const float turn : {0.0F, 0.125F, 0.25F, 0.5F, 0.75F, 1.0F, -0.25F, 3.375F}) {
        points.push_back({1.0F, 0.25F, {1, 0, 0}, {turn, 1.0F - turn}});
    }
    const std::vector<Answer> answers = probe(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const QuadVec3 exact = reference::position(torusOf(points[i]), {points[i].uv[0], points[i].uv[1]});
        // Two ulp of R + r: sine, cosine, sum and product.
        EXPECT_LE(difference(exact, answers[i].position), 2.4e-7 * (1.0 + double(points[i].minorRadius)));
    }
}

TEST_F(Surface, TangentsAreTheDerivatives) {
    const std::vector<Point> points = surfacePoints();
    const std::vector<Answer> answers = probe(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const reference::Tangents exact =
            reference::tangents(torusOf(points[i]), reference::toQuad(points[i].point));
        const double rounding = 6.3 * 2.4e-7 * (1.0 + double(points[i].minorRadius));  // 2 pi times two ulp
        EXPECT_LE(difference(exact.dPdu, answers[i].dPdu), rounding);
        EXPECT_LE(difference(exact.dPdv, answers[i].dPdv), rounding);
    }
}

TEST_F(Surface, DistanceAndImplicitAreRightEverywhere) {
    std::vector<Point> points;
    for (const float minorRadius : radii) {
        for (int i = 0; i < 1000; ++i) {
            const auto coordinate = [i](int k) {
                return 4.0F * std::fmod(0.6180340F * float(i * 3 + k) + 0.1F * float(i), 1.0F) - 2.0F;
            };
            points.push_back({1.0F, minorRadius, {coordinate(0), coordinate(1), coordinate(2)}, {0, 0}});
        }
        points.push_back({1.0F, minorRadius, {0, 0, 0}, {0, 0}});
        points.push_back({1.0F, minorRadius, {0, 0, 0.5F}, {0, 0}});
        points.push_back({1.0F, minorRadius, {1e-3F, 0, -0.25F}, {0, 0}});
    }
    const std::vector<Answer> answers = probe(points);
    int inside = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const QuadVec3 point = reference::toQuad(points[i].point);
        const double distance = reference::toDouble(reference::distance(torusOf(points[i]), point));
        inside += distance < 0.0 ? 1 : 0;
        EXPECT_NEAR(double(answers[i].distance), distance, 1e-6) << i;  // four roundings of numbers up to 5
        const double implicit = reference::toDouble(reference::implicit(torusOf(points[i]), point));
        // Both factors are up to 30, with some eight roundings of relative 6e-8 between them.
        EXPECT_NEAR(double(answers[i].implicit), implicit, 2e-6 * (10.0 + std::abs(implicit))) << i;
    }
    EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace raytorus
