// SPDX-License-Identifier: MIT
#include "verify/thresholds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raytorus::verify {
namespace {

using reference::RayClass;

// The verdict near a tangent moves with the last bits of the ray and of G; the thinner, the more. Measured on
// 100 000 rays of a ray group, the worst distance (docs/accuracy.md).
double wrongPartNearTangents(const RayGroup& group) {
    const float r = group.minorRadius;
    const bool near = group.margin < 1e-5;
    switch (group.rayClass) {
        case RayClass::topCircle:
            if (r < 1e-5F) {
                return r >= 1e-6F ? (near ? 0.027 : 0.0085) : (near ? 0.086 : 0.06);
            }
            return r >= 1e-3F ? 0.0 : (r >= 1e-4F ? 1.5e-4 : 1.8e-3);
        case RayClass::dimpleCone:
        case RayClass::hornTip:
            return 2e-5;
        default:
            return r >= 0.01F ? (near ? 2e-6 : 0.0) : (r >= 1e-5F ? 5e-5 : (r >= 1e-6F ? 3e-4 : 1.9e-3));
    }
}

// Of rays of which a part is wrong, the most that chance makes of it: four standard deviations. Of a few,
// two.
double allowedOf(double wrongPart, double judged) {
    const double expected = wrongPart * judged;
    return wrongPart > 0.0 ? std::max(2.0, std::floor(expected + 4.0 * std::sqrt(expected))) : 0.0;
}

Thresholds exactThresholds(const RayGroup& group) {
    Thresholds most;
    if (group.passesByMargin()) {
        most.wrongPart = wrongPartNearTangents(group);
        most.positionMax = most.positionP99 = most.surfaceMax = most.tP99 = most.tMax = INFINITY;
        return most;
    }
    // A tube as thin as the rounding of its place.
    most.wrongPart = group.minorRadius >= 1e-6F ? 0.0 : 3e-5;
    most.positionP99 = 0x1p-24;
    most.positionMax = most.surfaceMax = judge::positionBound;
    most.tP99 = 0.55;  // half an ulp; the histogram's bins are a sixteenth wide
    // What G's own rounding, 2^-47 (R + r)^2, makes of a crossing as flat as clear ones are, of a slope of
    // 0.04 r, in ulp of (R + r) / 16, the shortest t that counts.
    most.tMax = judge::tBound + 0x1p-47 / 0.04 / 0x1p-28 * (1.0 + group.minorRadius) / group.minorRadius;
    return most;
}

// Measured, with room (docs/accuracy.md): plain float32 has no bound worth stating, for the rounding of a
// point's distance from the axis moves a crossing by as much over the slope.
Thresholds fastThresholds(const RayGroup& group) {
    Thresholds most;
    most.tP99 = most.tMax = most.positionMax = most.positionP99 = most.surfaceMax = INFINITY;
    if (group.passesByMargin() || group.minorRadius < 0.001F) {
        most.wrongPart = 1.0;
        return most;
    }
    // A horn's tip is flat as a fourth power; positions that are gross in so thin a tube are a hundredth of
    // its radius off.
    const bool flat = group.minorRadius == 1.0F || group.minorRadius < 0.01F;
    const bool near = group.distance <= 1000.0;
    most.wrongPart = flat ? 5e-3 : (near ? 0.0 : 2e-3);
    // One clear ray in a million meets a dimple's tip, or starts or ends nearer to a thin tube than what
    // counts as on it.
    const bool rarelyWrong = group.minorRadius > 1.0F || group.minorRadius < 0.05F;
    most.wrongPart = rarelyWrong ? std::max(most.wrongPart, 1e-5) : most.wrongPart;
    if (near) {
        most.positionP99 = 5e-6;
        most.positionMax = most.surfaceMax = 1e-2;
        // As much along the ray, in ulp of the shortest t that counts.
        most.tP99 = most.positionP99 * 0x1p28;
        most.tMax = most.positionMax * 0x1p28;
    }
    return most;
}

}  // namespace

Thresholds thresholdsOf(const RayGroup& group, reference::Tier tier) {
    return tier == reference::Tier::Fast ? fastThresholds(group) : exactThresholds(group);
}

std::vector<std::string> exceededThresholds(const RayGroup& group, const Statistics& statistics,
                                            reference::Tier tier) {
    const Thresholds most = thresholdsOf(group, tier);
    std::vector<std::string> exceeded;
    const std::string name =
        fmt::format("{} r/R {:g} D/R {:g}", group.className(), group.minorRadius, group.distance);
    const auto judged = static_cast<double>(statistics.judged());
    const double allowed = allowedOf(most.wrongPart, judged);
    if (static_cast<double>(statistics.faultCount()) > allowed) {
        exceeded.push_back(fmt::format("{}: {} of {} rays are wrong, {:g} may be", name,
                                       statistics.faultCount(), statistics.judged(), allowed));
    }
    const auto hold = [&](const char* what, double value, double limit, const char* unit) {
        if (value > limit) {
            exceeded.push_back(
                fmt::format("{}: {} is {:.3g} {}, {:.3g} is allowed", name, what, value, unit, limit));
        }
    };
    const judge::Histogram& position = statistics.position.histogram;
    const judge::Histogram& t = statistics.t.histogram;
    hold("p99 of the position error", position.quantile(0.99), most.positionP99, "(R + r)");
    hold("the largest position error", position.max(), most.positionMax, "(R + r)");
    hold("the largest distance from the surface", statistics.surface.histogram.max(), most.surfaceMax,
         "(R + r)");
    hold("p99 of the error of t", t.quantile(0.99), most.tP99, "ulp");
    hold("the largest error of t", t.max(), most.tMax, "ulp");
    return exceeded;
}

}  // namespace raytorus::verify
