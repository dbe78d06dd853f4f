// SPDX-License-Identifier: MIT
#include "verify/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/random.hpp"

namespace raytorus::verify {
namespace {

using reference::RayClass;

// Where the rays of a class start is the class' business: a distance means nothing to it.
bool startsAtTorus(RayClass rayClass) {
    return rayClass == RayClass::inside || rayClass == RayClass::hole || rayClass == RayClass::leaving;
}

// A horn has a tip, a spindle has dimples.
bool exists(RayClass rayClass, float radius) {
    return rayClass == RayClass::hornTip ? radius == 1.0F : rayClass != RayClass::dimpleCone || radius > 1.0F;
}

// low * (high / low)^(64ths / 64), by square roots, which are the same on every platform.
double between(double low, double high, int sixtyFourths) {
    double value = low;
    double root = high / low;
    for (int bit = 32; bit > 0; bit /= 2) {
        root = std::sqrt(root);
        value *= (sixtyFourths & bit) != 0 ? root : 1.0;
    }
    return value;
}

// The verdict near a tangent moves with the last bits of the ray and of G; the thinner, the more. Measured on
// 100 000 rays of a cell, the worst distance (docs/accuracy.md).
double wrongPartNearTangents(const Cell& cell) {
    const float r = cell.minorRadius;
    const bool near = cell.margin < 1e-5;
    switch (cell.rayClass) {
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

Bar exactBar(const Cell& cell) {
    Bar bar;
    if (cell.passesByMargin()) {
        bar.wrongPart = wrongPartNearTangents(cell);
        bar.positionMax = bar.positionP99 = bar.surfaceMax = bar.tP99 = bar.tMax = INFINITY;
        return bar;
    }
    // A tube as thin as the rounding of its place.
    bar.wrongPart = cell.minorRadius >= 1e-6F ? 0.0 : 3e-5;
    bar.positionP99 = 0x1p-24;
    bar.positionMax = bar.surfaceMax = judge::positionBound;
    bar.tP99 = 0.55;  // half an ulp; the histogram's bins are a sixteenth wide
    // What G's own rounding, 2^-47 (R + r)^2, makes of a crossing as flat as clear ones are, of a slope of
    // 0.04 r, in ulp of (R + r) / 16, the shortest t that counts.
    bar.tMax = judge::tBound + 0x1p-47 / 0.04 / 0x1p-28 * (1.0 + cell.minorRadius) / cell.minorRadius;
    return bar;
}

// Measured, with room (docs/accuracy.md): plain float32 has no bound worth stating, for the rounding of a
// point's distance from the axis moves a crossing by as much over the slope.
Bar fastBar(const Cell& cell) {
    Bar bar;
    bar.tP99 = bar.tMax = bar.positionMax = bar.positionP99 = bar.surfaceMax = INFINITY;
    if (cell.passesByMargin() || cell.minorRadius < 0.001F) {
        bar.wrongPart = 1.0;
        return bar;
    }
    // A horn's tip is flat as a fourth power; positions that are gross in so thin a tube are a hundredth of
    // its radius off.
    const bool flat = cell.minorRadius == 1.0F || cell.minorRadius < 0.01F;
    const bool near = cell.distance <= 1000.0;
    bar.wrongPart = flat ? 5e-3 : (near ? 0.0 : 2e-3);
    // One clear ray in a million meets a dimple's tip, or starts or ends nearer to a thin tube than what
    // counts as on it.
    const bool rarelyWrong = cell.minorRadius > 1.0F || cell.minorRadius < 0.05F;
    bar.wrongPart = rarelyWrong ? std::max(bar.wrongPart, 1e-5) : bar.wrongPart;
    if (near) {
        bar.positionP99 = 5e-6;
        bar.positionMax = bar.surfaceMax = 1e-2;
        // As much along the ray, in ulp of the shortest t that counts.
        bar.tP99 = bar.positionP99 * 0x1p28;
        bar.tMax = bar.positionMax * 0x1p28;
    }
    return bar;
}

}  // namespace

reference::Ray Cell::ray(std::uint64_t seed, std::uint64_t index) const {
    reference::RayParameters parameters;
    parameters.torus = torus();
    parameters.distance = distance;
    parameters.seed = seed;
    if (passesByMargin()) {
        constexpr std::uint64_t marginStream = 1000;  // beyond the streams of the classes
        parameters.margin = between(margin, marginTo, reference::Random(seed, marginStream, index).below(64));
    }
    return reference::generateRay(rayClass, parameters, index).ray;
}

std::string Cell::className() const {
    const char* const name = reference::nameOf(rayClass);
    return passesByMargin() ? fmt::format("{} {:g}..{:g}", name, margin, marginTo) : name;
}

std::vector<Cell> chooseCells(const CellChoice& choice) {
    std::vector<RayClass> classes = choice.classes;
    if (classes.empty()) {
        classes.assign(std::begin(reference::allRayClasses), std::end(reference::allRayClasses));
    }
    std::vector<float> radii = choice.radii;
    if (radii.empty()) {
        radii = {1e-7F, 1e-6F, 1e-5F, 1e-4F, 0.001F, 0.01F, 0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};
    }
    std::vector<Cell> cells;
    for (const RayClass rayClass : classes) {
        const bool byMargin = reference::passesByMargin(rayClass);
        std::vector<double> distances = choice.distances;
        if (startsAtTorus(rayClass)) {
            distances = {0.0};
        } else if (distances.empty()) {
            distances = {1.5, 3.0, 10.0, 100.0};
            // A ray's own rounding moves it by 2^-24 of its length: from further away a margin of 1e-6 r is
            // lost.
            if (!byMargin) {
                distances.insert(distances.end(), {1e3, 1e4, 1e6});
            }
        }
        for (const float radius : radii) {
            if (!exists(rayClass, radius)) {
                continue;
            }
            for (const double distance : distances) {
                if (byMargin) {
                    cells.push_back({rayClass, radius, distance, 1e-6, 1e-5});
                    cells.push_back({rayClass, radius, distance, 1e-5, 1e-4});
                } else {
                    cells.push_back({rayClass, radius, distance});
                }
            }
        }
    }
    return cells;
}

Bar barOf(const Cell& cell, reference::Tier tier) {
    return tier == reference::Tier::Fast ? fastBar(cell) : exactBar(cell);
}

std::vector<std::string> brokenBars(const Cell& cell, const Statistics& statistics, reference::Tier tier) {
    const Bar bar = barOf(cell, tier);
    std::vector<std::string> broken;
    const std::string name =
        fmt::format("{} r/R {:g} D/R {:g}", cell.className(), cell.minorRadius, cell.distance);
    const auto judged = static_cast<double>(statistics.judged());
    const double allowed = allowedOf(bar.wrongPart, judged);
    if (static_cast<double>(statistics.faultCount()) > allowed) {
        broken.push_back(fmt::format("{}: {} of {} rays are wrong, {:g} may be", name,
                                     statistics.faultCount(), statistics.judged(), allowed));
    }
    const auto hold = [&](const char* what, double value, double most, const char* unit) {
        if (value > most) {
            broken.push_back(
                fmt::format("{}: {} is {:.3g} {}, {:.3g} is allowed", name, what, value, unit, most));
        }
    };
    const judge::Histogram& position = statistics.position.histogram;
    const judge::Histogram& t = statistics.t.histogram;
    hold("p99 of the position error", position.quantile(0.99), bar.positionP99, "(R + r)");
    hold("the largest position error", position.max(), bar.positionMax, "(R + r)");
    hold("the largest distance from the surface", statistics.surface.histogram.max(), bar.surfaceMax,
         "(R + r)");
    hold("p99 of the error of t", t.quantile(0.99), bar.tP99, "ulp");
    hold("the largest error of t", t.max(), bar.tMax, "ulp");
    return broken;
}

}  // namespace raytorus::verify
