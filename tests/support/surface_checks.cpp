// SPDX-License-Identifier: MIT
#include "surface_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/torus_reference.hpp"

namespace raytorus::test {
namespace {

using reference::QuadVec3;

constexpr std::array radii = {0.01F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};

// Points of the surface by even steps of uv, each also with that uv.
std::vector<SurfacePoint> surfacePoints() {
    std::vector<SurfacePoint> points;
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

reference::Torus torusOf(const SurfacePoint& point) {
    return {point.majorRadius, point.minorRadius};
}

double difference(const QuadVec3& exact, const float (&actual)[3]) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double off = std::abs(reference::toDouble(exact[i] - actual[i]));
        worst = off <= worst ? worst : off;  // a NaN stays
    }
    return worst;
}

double turnsBetween(double a, double b) {
    const double d = std::abs(a - b);
    return std::min(d, 1.0 - d);
}

// rho carries half an ulp of R, which turns the tube's radius by 2^-24 R / r.
double tubeRounding(const SurfacePoint& point) {
    return 2.4e-7 * (1.0 + double{point.majorRadius} / double{point.minorRadius});
}

double length(const float (&v)[3]) {
    return std::hypot(double{v[0]}, double{v[1]}, double{v[2]});
}

constexpr double unitRounding = 2.4e-7;  // the contract's 2^-22

// The sentence if `off` is more than `allowed`, or NaN.
std::string tooFar(const char* what, const SurfacePoint& point, double off, double allowed) {
    if (off <= allowed) {
        return "";
    }
    return fmt::format("{} is off by {:.3g}, {:.3g} is allowed (R {} r {}, point {} {} {}, uv {} {})", what,
                       off, allowed, point.majorRadius, point.minorRadius, point.point[0], point.point[1],
                       point.point[2], point.uv[0], point.uv[1]);
}

// The first sentence that `faultOf` has about a point and its answer.
template <class FaultOf>
std::string firstFault(const AskSurface& ask, const std::vector<SurfacePoint>& points, FaultOf faultOf) {
    const std::vector<SurfaceAnswer> answers = ask(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string fault = faultOf(points[i], answers[i]);
        if (!fault.empty()) {
            return fault;
        }
    }
    return "";
}

std::string rangeFault(const SurfacePoint& point, const SurfaceAnswer& answer) {
    for (const float value : answer.uv) {
        if (!(value >= 0.0F && value < 1.0F)) {
            return fmt::format("uv {} {} is not in [0, 1) (point {} {} {})", answer.uv[0], answer.uv[1],
                               point.point[0], point.point[1], point.point[2]);
        }
    }
    return "";
}

std::string normalFault(const AskSurface& ask) {
    return firstFault(ask, surfacePoints(), [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        const QuadVec3 exact = reference::normal(torusOf(point), reference::toQuad(point.point));
        const std::string fault =
            tooFar("the normal", point, difference(exact, answer.normal), tubeRounding(point));
        return fault.empty()
                   ? tooFar("the normal's length", point, std::abs(length(answer.normal) - 1.0), unitRounding)
                   : fault;
    });
}

// On the tube's centre circle and on the axis, where no direction is distinguished.
std::string undistinguishedNormalFault(const AskSurface& ask) {
    std::vector<SurfacePoint> points;
    for (const float z : {0.0F, 0.5F, -1.118034F}) {
        points.push_back({1.0F, 1.5F, {0, 0, z}, {0, 0}});  // on the axis; the last one on the surface
        points.push_back({0.0F, 1.0F, {0, 0, z}, {0, 0}});
    }
    for (const float z : {0.0F, -0.0F}) {
        points.push_back({1.0F, 0.25F, {1, 0, z}, {0, 0}});
        points.push_back({1.0F, 0.25F, {0, -1, z}, {0, 0}});
    }
    return firstFault(ask, points, [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        return tooFar("the normal's length", point, std::abs(length(answer.normal) - 1.0), unitRounding);
    });
}

std::string uvFault(const AskSurface& ask) {
    return firstFault(ask, surfacePoints(), [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        const reference::QuadVec2 exact = reference::uv(torusOf(point), reference::toQuad(point.point));
        // The polynomial's 2.2e-9 and half an ulp of 1.
        std::string fault =
            tooFar("u", point, turnsBetween(reference::toDouble(exact[0]), double{answer.uv[0]}), 1e-7);
        if (fault.empty()) {
            fault = tooFar("v", point, turnsBetween(reference::toDouble(exact[1]), double{answer.uv[1]}),
                           1e-7 + tubeRounding(point) / 6);
        }
        return fault.empty() ? rangeFault(point, answer) : fault;
    });
}

// On the axes of both circles, and an ulp below the seams, where 1 - tiny rounds to 1.
std::string seamFault(const AskSurface& ask) {
    std::vector<SurfacePoint> points;
    for (const float y : {0.0F, -0.0F, -1e-30F, 1e-30F, -1e-8F}) {
        for (const float x : {1.25F, -1.25F, 0.75F}) {
            points.push_back({1.0F, 0.25F, {x, y, 0.0F}, {0, 0}});
            points.push_back({1.0F, 0.25F, {x, 0.0F, y}, {0, 0}});
            points.push_back({1.0F, 0.25F, {y, x, 0.0F}, {0, 0}});
        }
    }
    points.push_back({1.0F, 0.25F, {0, 0, 0}, {0, 0}});
    const std::string fault = firstFault(ask, points, rangeFault);
    if (!fault.empty()) {
        return fault;
    }
    // Quarter turns, which are exact: the point carries the uv that it must have, or a value below 0.
    const std::vector<SurfacePoint> quarters = {{1.0F, 0.25F, {0, 1.25F, 0}, {0.25F, -1}},
                                                {1.0F, 0.25F, {-1.25F, 0, 0}, {0.5F, -1}},
                                                {1.0F, 0.25F, {0, -1.25F, 0}, {0.75F, -1}},
                                                {1.0F, 0.25F, {1, 0, 0.25F}, {-1, 0.25F}},
                                                {1.0F, 0.25F, {0.75F, 0, 0}, {-1, 0.5F}}};
    return firstFault(ask, quarters, [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        for (std::size_t i = 0; i < 2; ++i) {
            if (point.uv[i] >= 0.0F && answer.uv[i] != point.uv[i]) {
                return fmt::format("{} is {} instead of {}", i == 0 ? "u" : "v", answer.uv[i], point.uv[i]);
            }
        }
        return std::string();
    });
}

std::string positionFault(const AskSurface& ask) {
    std::vector<SurfacePoint> points = surfacePoints();
    for (const float turn : {0.0F, 0.125F, 0.25F, 0.5F, 0.75F, 1.0F, -0.25F, 3.375F}) {
        points.push_back({1.0F, 0.25F, {1, 0, 0}, {turn, 1.0F - turn}});
    }
    return firstFault(ask, points, [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        const QuadVec3 exact = reference::position(torusOf(point), {point.uv[0], point.uv[1]});
        // Two ulp of R + r: sine, cosine, sum and product.
        return tooFar("torusPosition", point, difference(exact, answer.position),
                      2.4e-7 * (1.0 + double{point.minorRadius}));
    });
}

std::string tangentFault(const AskSurface& ask) {
    return firstFault(ask, surfacePoints(), [](const SurfacePoint& point, const SurfaceAnswer& answer) {
        const reference::Tangents exact = reference::tangents(torusOf(point), reference::toQuad(point.point));
        const double rounding = 6.3 * 2.4e-7 * (1.0 + double{point.minorRadius});  // 2 pi times two ulp
        const std::string fault = tooFar("dPdu", point, difference(exact.dPdu, answer.dPdu), rounding);
        return fault.empty() ? tooFar("dPdv", point, difference(exact.dPdv, answer.dPdv), rounding) : fault;
    });
}

std::string distanceFault(const AskSurface& ask) {
    std::vector<SurfacePoint> points;
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
    int inside = 0;
    const std::string fault =
        firstFault(ask, points, [&inside](const SurfacePoint& point, const SurfaceAnswer& answer) {
            const QuadVec3 exactPoint = reference::toQuad(point.point);
            const double distance = reference::toDouble(reference::distance(torusOf(point), exactPoint));
            inside += distance < 0.0 ? 1 : 0;
            // Four roundings of numbers up to 5.
            const std::string wrong =
                tooFar("torusDistance", point, std::abs(double{answer.distance} - distance), 1e-6);
            const double implicit = reference::toDouble(reference::implicit(torusOf(point), exactPoint));
            // Both factors are up to 30, with some eight roundings of relative 6e-8 between them.
            return wrong.empty()
                       ? tooFar("torusImplicit", point, std::abs(double{answer.implicit} - implicit),
                                2e-6 * (10.0 + std::abs(implicit)))
                       : wrong;
        });
    return fault.empty() && inside <= 100 ? fmt::format("only {} points lie inside", inside) : fault;
}

}  // namespace

std::span<const SurfaceCheck> surfaceChecks() {
    static constexpr std::array checks = {
        SurfaceCheck{"normal", normalFault},
        SurfaceCheck{"normal without direction", undistinguishedNormalFault},
        SurfaceCheck{"uv", uvFault},
        SurfaceCheck{"uv at the seams", seamFault},
        SurfaceCheck{"position of uv", positionFault},
        SurfaceCheck{"tangents", tangentFault},
        SurfaceCheck{"distance and implicit function", distanceFault},
    };
    return checks;
}

}  // namespace raytorus::test
