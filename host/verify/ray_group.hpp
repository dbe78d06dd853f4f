// SPDX-License-Identifier: MIT
// What is verified: groups of rays of one class, one shape of torus and one distance.
#pragma once

#include <string>
#include <vector>

#include "judge/judge.hpp"
#include "reference/rays.hpp"

namespace raytorus::verify {

struct RayGroup {
    reference::RayClass rayClass = reference::RayClass::camera;
    float minorRadius = 0.25F;  ///< the major radius is 1
    double distance = 3.0;      ///< of origins from the centre, in R; 0 for a class that has none of its own
    double margin = 0.0;        ///< of classes that pass by a margin: from this part of r ...
    double marginTo = 0.0;      ///< ... to this

    [[nodiscard]] bool passesByMargin() const { return reference::passesByMargin(rayClass); }
    /// Whether roots in doubles are worth too few digits: near tangents, and in hair-thin tubes.
    [[nodiscard]] bool needsPreciseHits() const { return passesByMargin() || minorRadius < 1e-3F; }
    [[nodiscard]] reference::Torus torus() const { return {1.0F, minorRadius}; }
    /// From here on its rays are clear, in r: see isClear.
    [[nodiscard]] double tangentMargin() const { return passesByMargin() ? margin : judge::clearMargin; }
    /// The ray of that number.
    [[nodiscard]] reference::Ray ray(std::uint64_t seed, std::uint64_t index) const;
    /// "camera", "grazing 1e-06..1e-05".
    [[nodiscard]] std::string className() const;
};

struct RayGroupChoice {
    std::vector<reference::RayClass> classes;  ///< empty: all
    std::vector<float> radii;                  ///< empty: 1e-7 to 1e-3 by tens, .01 .05 .1 .25 .5 .9 1 1.5
    std::vector<double> distances;             ///< empty: 1.5 3 10 100 1e3 1e4 1e6; grazing to 100
};

/// Every combination that exists. Classes that start at the torus have one distance, none.
std::vector<RayGroup> chooseRayGroups(const RayGroupChoice& choice);

}  // namespace raytorus::verify
