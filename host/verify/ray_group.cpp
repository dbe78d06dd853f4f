// SPDX-License-Identifier: MIT
#include "verify/ray_group.hpp"

#include <fmt/format.h>

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

}  // namespace

reference::Ray RayGroup::ray(std::uint64_t seed, std::uint64_t index) const {
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

std::string RayGroup::className() const {
    const char* const name = reference::nameOf(rayClass);
    return passesByMargin() ? fmt::format("{} {:g}..{:g}", name, margin, marginTo) : name;
}

std::vector<RayGroup> chooseRayGroups(const RayGroupChoice& choice) {
    std::vector<RayClass> classes = choice.classes;
    if (classes.empty()) {
        classes.assign(std::begin(reference::allRayClasses), std::end(reference::allRayClasses));
    }
    std::vector<float> radii = choice.radii;
    if (radii.empty()) {
        radii = {1e-7F, 1e-6F, 1e-5F, 1e-4F, 0.001F, 0.01F, 0.05F, 0.1F, 0.25F, 0.5F, 0.9F, 1.0F, 1.5F};
    }
    std::vector<RayGroup> groups;
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
                    groups.push_back({rayClass, radius, distance, 1e-6, 1e-5});
                    groups.push_back({rayClass, radius, distance, 1e-5, 1e-4});
                } else {
                    groups.push_back({rayClass, radius, distance});
                }
            }
        }
    }
    return groups;
}

}  // namespace raytorus::verify
