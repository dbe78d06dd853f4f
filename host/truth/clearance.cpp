// SPDX-License-Identifier: MIT
#include "truth/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/intersect.hpp"

namespace raytorus::truth {

TubeDistance::TubeDistance(const scene_io::SceneTorus& torus, const SceneRay<DoubleDouble>& local)
    : shape(static_cast<double>(torus.radii.x), static_cast<double>(torus.radii.y)) {
    const int size = std::ilogb(std::max(torus.radii.x, torus.radii.y));
    double longest = 0.0;
    for (const DoubleDouble& component : local.direction) {
        longest = std::max(longest, std::abs(component.high));
    }
    const int speed = std::ilogb(longest);
    lengthUnit = std::ldexp(1.0, size);
    tUnit = std::ldexp(1.0, size - speed);
    shape.majorRadius /= lengthUnit;
    shape.minorRadius /= lengthUnit;
    SceneRay<DoubleDouble> scaled;
    for (std::size_t i = 0; i < 3; ++i) {
        scaled.origin[i] = timesPowerOfTwo(local.origin[i], -size);
        scaled.direction[i] = timesPowerOfTwo(local.direction[i], -speed);
    }
    const auto line = reference::shiftedToFoot(scaled.origin, scaled.direction);
    point = toDoubles(line.point);
    direction = toDoubles(line.direction);
    shift = line.shift;
    const reference::LineForms<double> forms(shape, point, direction);
    const double moment = point[0] * direction[1] - point[1] * direction[0];
    const reference::Extrema found =
        reference::tubeExtrema(shape.majorRadius, forms.A, forms.B, forms.a, forms.b, moment * moment);
    extremumCount = found.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
        extrema[i] = toDouble(shift + DoubleDouble(found.at[i])) * tUnit;
    }
}

double TubeDistance::at(double t) const {
    const double u = toDouble(DoubleDouble(t / tUnit) - shift);
    return reference::tubeDistance(shape, point + u * direction) * lengthUnit;
}

double clearanceOf(const TubeDistance& distance, double tMax) {
    // Beyond this a line is outside of everything; f there would only overflow.
    constexpr double endless = 1e30;
    const double start = distance.at(0.0);
    const double stop = tMax < endless ? distance.at(tMax) : std::numeric_limits<double>::infinity();
    double least = std::min(start, stop);
    double most = std::max(start, stop);
    for (std::size_t i = 0; i < static_cast<std::size_t>(distance.extremumCount); ++i) {
        const double t = distance.extrema[i];
        if (t > 0.0 && t < tMax) {
            least = std::min(least, distance.at(t));
            most = std::max(most, distance.at(t));
        }
    }
    return std::max(least, -most);
}

double sphereClearance(const scene_io::SceneTorus& torus, const SceneRay<double>& ray, double tMax) {
    const Vec3<double> toCentre = originOf<double>(torus) - ray.origin;
    const double t = std::clamp(dot(toCentre, ray.direction) / dot(ray.direction, ray.direction), 0.0, tMax);
    // The rows of the rotation are orthogonal to some 1e-7.
    return length(t * ray.direction - toCentre) * (1.0 - 1e-6) - outerRadius(torus);
}

Clearance leastClearance(const SceneData& scene, const SceneRay<DoubleDouble>& ray, double tMax) {
    const SceneRay<double> plain{toDoubles(ray.origin), toDoubles(ray.direction)};
    Clearance least{std::numeric_limits<double>::infinity(), -1};
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        const scene_io::SceneTorus& torus = scene.tori[i];
        if (sphereClearance(torus, plain, tMax) > least.length) {
            continue;
        }
        const double clearance = clearanceOf(TubeDistance(torus, toTorus(torus, ray)), tMax);
        if (clearance < least.length) {
            least = {clearance, static_cast<int>(i)};
        }
    }
    return least;
}

}  // namespace raytorus::truth
