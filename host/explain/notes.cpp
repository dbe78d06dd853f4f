// SPDX-License-Identifier: MIT
#include "explain/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/torus_range.hpp"
#include "explain/number_text.hpp"
#include "reference/promise.hpp"

namespace raytorus::explain {
namespace {

using Notes = std::vector<std::string>;

Quad lengthOf(const Vec3<Quad>& v) {
    return reference::squareRoot(reference::dot(v, v));
}

// The limits of the contract for a direction's length.
constexpr double shortest = 1e-18, longest = 1e18;

bool isFinite(const float (&v)[3]) {
    return std::all_of(std::begin(v), std::end(v), [](float x) { return std::isfinite(x); });
}

void addNumberFaults(const reference::Torus& torus, const reference::Ray& ray, Notes& faults) {
    if (!std::isfinite(torus.majorRadius) || !std::isfinite(torus.minorRadius)) {
        faults.push_back("a radius is not finite");
    }
    if (torus.majorRadius < 0.0F) {
        faults.push_back(fmt::format("R = {} is negative", decimal(torus.majorRadius)));
    }
    if (torus.minorRadius <= 0.0F) {
        faults.push_back(fmt::format("r = {} is not positive", decimal(torus.minorRadius)));
    }
    if (!isFinite(ray.origin)) {
        faults.push_back("the origin is not finite");
    }
    if (!isFinite(ray.direction)) {
        faults.push_back("the direction is not finite");
    } else if (lengthOf(reference::toQuad(ray.direction)) == 0) {
        faults.push_back("the direction is zero");
    }
    if (std::isnan(ray.tMin) || std::isnan(ray.tMax)) {
        faults.push_back("tMin or tMax is no number");
    } else if (ray.tMin > ray.tMax) {
        faults.push_back("tMin is greater than tMax");
    }
}

void addSizeFaults(const reference::Torus& torus, const reference::Ray& ray, Notes& faults) {
    const double size = double{torus.majorRadius} + double{torus.minorRadius};
    const double length = reference::toDouble(lengthOf(reference::toQuad(ray.direction)));
    if (!isTorusInRange(torus.majorRadius, torus.minorRadius)) {
        faults.push_back(
            fmt::format("R + r = {:.3g} is not from {:g} to {:g}", size, smallestTorus, largestTorus));
    }
    if (!(length >= shortest && length <= longest)) {
        faults.push_back(fmt::format("the direction is {:.3g} long, not 1e-18 to 1e18", length));
    }
}

void addDirectionNotes(const Explanation& e, Notes& notes) {
    const Vec3<Quad> direction = reference::toQuad(e.ray.direction);
    if (direction[0] == 0 && direction[1] == 0) {
        notes.push_back("parallel to the axis");
    } else if (direction[2] == 0) {
        notes.push_back(e.ray.origin[2] == 0.0F ? "in the equatorial plane, z = 0"
                                                : "perpendicular to the axis");
    }
    const Quad length = lengthOf(direction);
    if (reference::magnitude(length - 1) > 1e-6) {  // what float32 can do about a unit vector, ten times
        notes.push_back(fmt::format("the direction is {:.6g} long: t counts in that length",
                                    reference::toDouble(length)));
    }
}

// A sphere's distances are told in r.
void addPlaceNotes(const Explanation& e, Notes& notes) {
    const Vec3<Quad> o = reference::toQuad(e.ray.origin), d = reference::toQuad(e.ray.direction);
    const Vec3<Quad> moment{o[1] * d[2] - o[2] * d[1], o[2] * d[0] - o[0] * d[2], o[0] * d[1] - o[1] * d[0]};
    const Quad across = reference::squareRoot(d[0] * d[0] + d[1] * d[1]);
    const Quad fromCentre = lengthOf(moment) / lengthOf(d);
    const Quad fromAxis = across > 0 ? reference::magnitude(moment[2]) / across : fromCentre;
    const Quad unit = e.torus.majorRadius > 0.0F ? e.torus.majorRadius : e.torus.minorRadius;
    const char* name = e.torus.majorRadius > 0.0F ? "R" : "r";
    if (fromCentre == 0) {
        notes.push_back("passes through the centre");
    } else {
        notes.push_back(fmt::format(
            "passes the centre at {:.6g} {}, {}", reference::toDouble(fromCentre / unit), name,
            fromAxis == 0
                ? "meets the axis"
                : fmt::format("the axis at {:.6g} {}", reference::toDouble(fromAxis / unit), name)));
    }
    const double size = double{e.torus.majorRadius} + double{e.torus.minorRadius};
    const double away = reference::toDouble(lengthOf(o)) / size;
    if (away > 100.0) {
        notes.push_back(
            fmt::format("starts {:.3g} (R + r) away, where neighbouring floats are {} (R + r) apart", away,
                        roughly(floatUlp(away * size) / size)));
    }
    if (e.startsInside) {
        notes.push_back("starts inside the solid");
    }
}

void addDoubts(const Explanation& e, Notes& notes) {
    if (e.clearance < negligible) {
        notes.push_back("tangent: a touching line has both hits or neither");
    } else if (e.clearance < reference::clearMargin) {
        notes.push_back(fmt::format("nearly tangent: the distance has an extremum {} r from the surface",
                                    roughly(e.clearance)));
    }
    const double margin = reference::clearEndMargin(e.torus);
    for (const auto& [name, clearance] :
         {std::pair("tMin", e.startClearance), std::pair("tMax", e.stopClearance)}) {
        if (clearance < margin) {
            notes.push_back(
                fmt::format("at {} the ray is {} r from the surface: a hit there may go either way", name,
                            roughly(clearance)));
        }
    }
}

}  // namespace

std::vector<std::string> faultsOf(const reference::Torus& torus, const reference::Ray& ray) {
    Notes faults;
    addNumberFaults(torus, ray, faults);
    if (faults.empty()) {
        addSizeFaults(torus, ray, faults);
    }
    return faults;
}

std::vector<std::string> notesOf(const Explanation& e) {
    Notes notes;
    addDirectionNotes(e, notes);
    addPlaceNotes(e, notes);
    addDoubts(e, notes);
    if (e.torus.majorRadius == 0.0F) {
        notes.push_back("R = 0, a sphere: it has no reduced quartic, and the closed form does not answer");
    } else if (e.exact.tubeRadius > 100) {
        notes.push_back("r > 100 R: the closed form does not answer");
    } else if (!e.shader.reduced) {
        notes.push_back("passes the bounding sphere by: the shaders stop there");
    }
    if (e.torus.minorRadius > e.torus.majorRadius && e.torus.majorRadius > 0.0F) {
        notes.push_back("of a spindle the outer sheet is the surface: roots on the inner one are no hits");
    }
    return notes;
}

}  // namespace raytorus::explain
