// SPDX-License-Identifier: MIT
#include "stage_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/double_double.hpp"
#include "reference/intersect.hpp"
#include "reference/rays.hpp"
#include "support/fresh_seed.hpp"

namespace raytorus::test {

using reference::DoubleDouble;
using reference::Quad;
using reference::Random;
using reference::Ray;
using reference::RayClass;
using reference::Torus;

std::string Trial::text() const {
    return reference::hexFloats(torus, ray);
}

std::span<const Torus> everySort() {
    static constexpr std::array sorts = {Torus{1, 1e-6F}, Torus{1, 1e-4F}, Torus{1, 0.01F}, Torus{1, 0.1F},
                                         Torus{1, 0.25F}, Torus{1, 0.5F},  Torus{1, 0.9F},  Torus{1, 1},
                                         Torus{1, 1.02F}, Torus{1, 1.5F},  Torus{1, 10},    Torus{0, 1}};
    return sorts;
}

Trial freshTrial(std::uint64_t index, double farthest) {
    Random random(freshSeed(), 100, index);
    const auto sorts = everySort();
    Torus torus = sorts[static_cast<std::size_t>(random.below(static_cast<int>(sorts.size())))];
    const float size = std::pow(10.0F, static_cast<float>(random.uniform(-3, 3)));
    torus.majorRadius *= size;
    torus.minorRadius *= size;
    RayClass rayClass =
        reference::allRayClasses[static_cast<std::size_t>(random.below(std::size(reference::allRayClasses)))];
    // The hole's rays need room beside the axis.
    rayClass = torus.majorRadius == 0 && rayClass == RayClass::hole ? RayClass::camera : rayClass;
    reference::RayParameters parameters;
    parameters.torus = torus;
    parameters.distance = std::pow(10.0, random.uniform(0, std::log10(farthest)));
    parameters.margin = std::pow(10.0, random.uniform(-7, -1));
    parameters.seed = freshSeed();
    return {torus, reference::generateRay(rayClass, parameters, index).ray};
}

Random freshNumbers(std::uint64_t index) {
    return {freshSeed(), 101, index};
}

Long parameterOf(const LineStage& line, Quad t) {
    return static_cast<Long>(t * Quad(line.uPerT) - Quad(line.baseShift) - Quad(line.shift));
}

float anyPlace(const LineStage& line, const ExactLine& exact, Random& random) {
    double u = random.uniform(double{line.lower}, double{line.upper});
    if (!exact.roots.empty() && random.below(2) == 0) {
        const int root = random.below(static_cast<int>(exact.roots.size()));
        const double off = random.sign() * std::pow(10.0, random.uniform(-9, -1));
        u = static_cast<double>(exact.roots[static_cast<std::size_t>(root)] + Long{off} * exact.r);
    }
    return std::clamp(static_cast<float>(u), line.lower, line.upper);
}

ExactLine::ExactLine(const Trial& trial, const LineStage& line)
    : R(static_cast<Long>(trial.torus.majorRadius) / line.unit),
      r(static_cast<Long>(trial.torus.minorRadius) / line.unit) {
    // Powers of two: the quotients are exact.
    const Quad directionUnit = Quad(line.uPerT) * Quad(line.unit);
    const Quad shift = Quad(line.baseShift) + Quad(line.shift);
    length2 = foot2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Quad d = Quad(trial.ray.direction[i]) / directionUnit;
        direction[i] = static_cast<Long>(d);
        foot[i] = static_cast<Long>(Quad(trial.ray.origin[i]) / Quad(line.unit) + shift * d);
        length2 += direction[i] * direction[i];
        foot2 += foot[i] * foot[i];
    }
    // The library's foot is the nearest point but for rounding. That leaves f a cubic term, which is in no
    // formula here: f is evaluated from the point.
    b1 = 2 * R * direction[2] / length2;
    edge = 2 * R * r / length2;
    Ray whole = trial.ray;
    whole.tMin = -std::numeric_limits<float>::infinity();
    whole.tMax = std::numeric_limits<float>::infinity();
    const auto truth = reference::intersectAs<DoubleDouble>(reference::BasicTorus<DoubleDouble>(trial.torus),
                                                            reference::BasicRay<DoubleDouble>(whole));
    clearance = truth.clearance;
    for (int i = 0; i < truth.count; ++i) {
        const DoubleDouble& t = truth.hits[static_cast<std::size_t>(i)].t;
        roots.push_back(parameterOf(line, Quad(t.high) + Quad(t.low)));
    }
}

std::array<Long, 3> ExactLine::point(Long u) const {
    return {foot[0] + u * direction[0], foot[1] + u * direction[1], foot[2] + u * direction[2]};
}

Long ExactLine::tube(Long u) const {
    const auto [x, y, z] = point(u);
    const Long q = std::sqrt(x * x + y * y) - R;
    return (q - r) * (q + r) + z * z;
}

Long ExactLine::f(Long u) const {
    const auto [x, y, z] = point(u);
    const Long a = (x * x + y * y + z * z - R * R - r * r) / length2;
    const Long b = 2 * R * z / length2;
    return a * a + (b - edge) * (b + edge);
}

Long ExactLine::h(Long u) const {
    const auto [x, y, z] = point(u);
    const Long a = (x * x + y * y + z * z - R * R - r * r) / length2;
    const Long along = (x * direction[0] + y * direction[1] + z * direction[2]) / length2;
    return 2 * along * a + b1 * (2 * R * z / length2);
}

float ExactLine::side(Long u) const {
    return tube(u) < 0 ? -1.0F : 1.0F;
}

bool ExactLine::meetsATip() const {
    if (r < R) {
        return false;
    }
    const Long near2 = r * r / 400;
    const Long height = std::sqrt((r - R) * (r + R));
    for (const Long z : {-height, height}) {
        // The point of the line that is nearest to the tip.
        const auto [x, y, h] = point(z * direction[2] / length2);
        if (x * x + y * y + (h - z) * (h - z) < near2) {
            return true;
        }
    }
    return std::ranges::any_of(roots, [&](Long u) {
        const auto [x, y, z] = point(u);
        return x * x + y * y < near2;
    });
}

}  // namespace raytorus::test
