// SPDX-License-Identifier: MIT
// Random rays by named class, the same on every platform: each follows from (class, parameters, seed, index)
// alone, by an own generator and by + - * / sqrt, which IEEE 754 defines to the last bit.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "reference/torus_reference.hpp"

namespace raytorus::reference {

// Branches are numbered from 0 in the order given.
enum class RayClass {
    camera,         // aims at: the bounding sphere | the surface | the sphere, up to tMax = the largest float
    inside,         // starts inside the solid, direction: random | nearly along the tube
    hole,           // starts: in the hole (or, where there is none, above the dimple) | below it
    equatorial,     // in the plane z = +-0, starts: at the distance | within the outer equator
    axisParallel,   // runs: downwards | upwards | along the axis itself
    throughAxis,    // meets the axis: exactly | but for the rounding of the origin
    throughCentre,  // meets the centre: exactly | but for the rounding of the origin
    leaving,  // starts on the surface, tMin = 1e-3 r, direction and offset: out, on | out, above | in, below
    axisAligned,  // zeros of both signs; runs along: x | y | z | a plane x = const | y = const | z = const
    nonUnit,      // a camera ray whose direction has a length of: 1e-18..1 | 1..1e18
    grazing,      // passes a surface point at `margin` r: outside | inside
    segment,      // a camera ray with: tMin and tMax near the solid | tMax before it | tMin beyond its centre
    topCircle,    // runs along the top circle, nearly in fourfold contact, at `margin` r: outside | inside
    dimpleCone,   // along the cone in which a spindle's dimple ends, at `margin` r: outside | inside
    hornTip,      // past a horn's tip: across | nearly along the axis
};

inline constexpr RayClass allRayClasses[] = {
    RayClass::camera,       RayClass::inside,      RayClass::hole,          RayClass::equatorial,
    RayClass::axisParallel, RayClass::throughAxis, RayClass::throughCentre, RayClass::leaving,
    RayClass::axisAligned,  RayClass::nonUnit,     RayClass::grazing,       RayClass::segment,
    RayClass::topCircle,    RayClass::dimpleCone,  RayClass::hornTip};

// Whether the rays of a class come near to a tangent on purpose, and are judged however near. All but those
// of hornTip are aimed to pass the surface by `margin`.
constexpr bool passesByMargin(RayClass rayClass) {
    return rayClass == RayClass::grazing || rayClass == RayClass::topCircle ||
           rayClass == RayClass::dimpleCone || rayClass == RayClass::hornTip;
}

const char* nameOf(RayClass rayClass);
// For GoogleTest's messages.
inline void PrintTo(RayClass rayClass, std::ostream* out) {
    *out << nameOf(rayClass);
}
int branchCount(RayClass rayClass);

struct RayParameters {
    Torus torus{1.0f, 0.25f};
    double distance = 3;   // of the origin from the centre, in units of the larger radius; see originDistance
    double margin = 1e-4;  // of classes that pass by it, in units of minorRadius
    std::uint64_t seed = 1;
};

struct GeneratedRay {
    Ray ray;
    int branch;
};

GeneratedRay generateRay(RayClass rayClass, const RayParameters& parameters, std::uint64_t index);
std::vector<Ray> generateRays(RayClass rayClass, const RayParameters& parameters, std::uint64_t count);

// Class, parameters, index and the ray itself as hexFloats: all that is needed to replay a failing trial.
std::string describeRay(RayClass rayClass, const RayParameters& parameters, std::uint64_t index);

// The distance that a generator uses: as asked for, but never within the bounding sphere.
double originDistance(const RayParameters& parameters);

// "R r  ox oy oz tMin  dx dy dz tMax" as hexadecimal floats, for the message of a failing test, and back.
struct TorusAndRay {
    Torus torus;
    Ray ray;
};
std::string hexFloats(const Torus& torus, const Ray& ray);
std::optional<TorusAndRay> parseHexFloats(const std::string& text);

}  // namespace raytorus::reference
