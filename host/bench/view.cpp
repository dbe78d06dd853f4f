// SPDX-License-Identifier: MIT
#include "bench/view.hpp"

#include <cmath>
#include <numbers>

#include "reference/random.hpp"

namespace raytorus::bench {
namespace {

using reference::DoubleVec3;
using reference::operator+;
using reference::operator-;
using reference::operator*;

constexpr double elevation = 35.0;     // of the camera over the torus' plane, degrees
constexpr double aimTurn = 60.0;       // of the point it looks at from the nearest one of the ring
constexpr double leastOpening = 0.01;  // in r
constexpr double openingFactor = 1.5;
constexpr int openings = 60;  // up to 3e8 r: from anywhere that is the whole sky
constexpr int halvings = 12;  // of the last factor: to some 1e-4 of the opening

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

DoubleVec3 cross(const DoubleVec3& a, const DoubleVec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void store(const DoubleVec3& from, float (&to)[3]) {
    for (std::size_t i = 0; i < 3; ++i) {
        to[i] = static_cast<float>(from[i]);
    }
}

}  // namespace

RayView makeView(const Workload& workload, std::uint32_t pixels, std::uint64_t seed, double opening) {
    reference::Random random(seed, 0, 0);
    const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
    RayView view{};
    view.majorRadius = workload.torus().majorRadius;
    view.minorRadius = workload.minorRadius;
    view.tMax = rayEnd;
    view.startDistance = static_cast<float>(workload.distance);
    view.seed = static_cast<std::uint32_t>(random.next());
    const double size = opening * double{workload.minorRadius};
    if (workload.pattern == Pattern::Scattered) {
        view.spread = static_cast<float>(size);
        return view;
    }
    const double up = radians(elevation);
    const DoubleVec3 origin = workload.distance * DoubleVec3{std::cos(up) * std::cos(azimuth),
                                                             std::cos(up) * std::sin(azimuth), std::sin(up)};
    const double ring = azimuth + radians(aimTurn);
    const DoubleVec3 forward = DoubleVec3{std::cos(ring), std::sin(ring), 0.0} - origin;
    const DoubleVec3 right = reference::unit(cross(forward, {0.0, 0.0, 1.0}));
    const DoubleVec3 above = reference::unit(cross(right, forward));
    const double pixel = 2.0 * size / pixels;
    const double first = 0.5 * pixel - size;
    // Two of the three coordinates of the direction are of the size of the distance: as a camera has them.
    store(origin, view.origin);
    store(forward + first * right + first * above, view.corner);
    store(pixel * right, view.right);
    store(pixel * above, view.up);
    return view;
}

RayView aim(const Workload& workload, std::uint32_t pixels, std::uint64_t seed,
            const std::function<double(const RayView&)>& hitPart) {
    const double wanted = 0.01 * workload.hitPercent;
    double opening = leastOpening;
    RayView best = makeView(workload, pixels, seed, opening);
    double bestOff = 1.0;
    const auto tooMany = [&](double tried) {
        const RayView view = makeView(workload, pixels, seed, tried);
        const double part = hitPart(view);
        if (std::abs(part - wanted) < bestOff) {
            bestOff = std::abs(part - wanted);
            best = view;
        }
        return part > wanted;
    };
    for (int i = 0; i < openings && tooMany(opening); ++i) {
        opening *= openingFactor;
    }
    double low = opening / openingFactor;
    for (int i = 0; i < halvings; ++i) {
        const double middle = std::sqrt(low * opening);
        (tooMany(middle) ? low : opening) = middle;
    }
    return best;
}

}  // namespace raytorus::bench
