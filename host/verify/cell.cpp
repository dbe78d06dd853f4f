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

}  // namespace

reference::Ray Cell::ray(std::uint64_t seed, std::uint64_t index) const {
    reference::RayParameters parameters;
    parameters.torus = torus();
    parameters.distance = distance;
    parameters.seed = seed;
    if (isGrazing()) {
        constexpr std::uint64_t marginStream = 1000;  // beyond the streams of the classes
        parameters.margin = between(margin, marginTo, reference::Random(seed, marginStream, index).below(64));
    }
    return reference::generateRay(rayClass, parameters, index).ray;
}

std::string Cell::className() const {
    return isGrazing() ? fmt::format("grazing {:g}..{:g}", margin, marginTo) : reference::nameOf(rayClass);
}

std::vector<Cell> chooseCells(const CellChoice& choice) {
    std::vector<RayClass> classes = choice.classes;
    if (classes.empty()) {
        classes.assign(std::begin(reference::allRayClasses), std::end(reference::allRayClasses));
    }
    std::vector<float> radii = choice.radii;
    if (radii.empty()) {
        radii = {0.001F, 0.01F, 0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};
    }
    std::vector<Cell> cells;
    for (const RayClass rayClass : classes) {
        const bool grazing = rayClass == RayClass::grazing;
        std::vector<double> distances = choice.distances;
        if (startsAtTorus(rayClass)) {
            distances = {0.0};
        } else if (distances.empty()) {
            distances = {1.5, 3.0, 10.0, 100.0};
            // A ray's own rounding moves it by 2^-24 of its length: from further away a margin of 1e-6 r is
            // lost.
            if (!grazing) {
                distances.insert(distances.end(), {1e3, 1e4, 1e6});
            }
        }
        for (const float radius : radii) {
            for (const double distance : distances) {
                if (grazing) {
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

Bar barOf(const Cell& cell) {
    Bar bar;
    if (cell.isGrazing()) {
        // The verdict near a tangent moves with the last bits of the ray and of G; the thinner, the more.
        const bool close = cell.margin < 1e-5;
        bar.wrongPart = cell.minorRadius >= 0.25F   ? (close ? 0.002 : 0.0)
                        : cell.minorRadius >= 0.1F  ? (close ? 0.01 : 0.0)
                        : cell.minorRadius >= 0.01F ? (close ? 0.02 : 0.01)
                                                    : 0.02;
        // There is nothing to promise of positions: the hits of a grazing ray move without bound with its
        // rounding.
        bar.positionMax = bar.positionP99 = bar.surfaceMax = bar.tP99 = bar.tMax = INFINITY;
        return bar;
    }
    bar.positionP99 = 0x1p-24;
    bar.positionMax = bar.surfaceMax = positionBound;
    bar.tP99 = 0.55;  // half an ulp; the histogram's bins are a sixteenth wide
    bar.tMax = tBound;
    return bar;
}

std::vector<std::string> brokenBars(const Cell& cell, const Statistics& statistics) {
    const Bar bar = barOf(cell);
    std::vector<std::string> broken;
    const std::string name =
        fmt::format("{} r/R {:g} D/R {:g}", cell.className(), cell.minorRadius, cell.distance);
    const auto judged = static_cast<double>(statistics.judged());
    if (static_cast<double>(statistics.faultCount()) > bar.wrongPart * judged) {
        broken.push_back(fmt::format("{}: {} of {} rays are wrong, {:g} may be", name,
                                     statistics.faultCount(), statistics.judged(),
                                     std::floor(bar.wrongPart * judged)));
    }
    const auto hold = [&](const char* what, double value, double most, const char* unit) {
        if (value > most) {
            broken.push_back(
                fmt::format("{}: {} is {:.3g} {}, {:.3g} is allowed", name, what, value, unit, most));
        }
    };
    const Histogram& position = statistics.position.histogram;
    const Histogram& t = statistics.t.histogram;
    hold("p99 of the position error", position.quantile(0.99), bar.positionP99, "(R + r)");
    hold("the largest position error", position.max(), bar.positionMax, "(R + r)");
    hold("the largest distance from the surface", statistics.surface.histogram.max(), bar.surfaceMax,
         "(R + r)");
    hold("p99 of the error of t", t.quantile(0.99), bar.tP99, "ulp");
    hold("the largest error of t", t.max(), bar.tMax, "ulp");
    return broken;
}

}  // namespace raytorus::verify
