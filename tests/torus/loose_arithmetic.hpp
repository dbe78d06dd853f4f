// SPDX-License-Identifier: MIT
// The library's own GLSL, compiled as C++ over a float that is as inexact as Vulkan lets a device be
// ("Precision and Operation of SPIR-V Instructions" in the specification).
#pragma once

#include <cstdint>

#include "trace/tracer.hpp"

namespace raytorus::test {

/// What a device may do. How far each operation goes is drawn from its operands and a seed: the same every
/// time.
struct Arithmetic {
    /// + - *: an inexact result may be either neighbour of the exact one, since Vulkan leaves the rounding
    /// mode open.
    bool anyRounding = false;
    /// Ulps by which a rounded quotient may be off: Vulkan allows 2.5 in all.
    int divisionUlps = 0;
    /// The same of a square root, which inherits from 1.0 / inversesqrt(x): 2 ulp, up to doubled by the
    /// reciprocal where that crosses a power of two, and 2.5.
    int squareRootUlps = 0;
    std::uint64_t seed = 1;
};

inline constexpr int allowedDivisionUlps = 2;
inline constexpr int allowedSquareRootUlps = 6;

/// Holds until the next call.
void setArithmetic(const Arithmetic& arithmetic);

trace::NearestHit looseNearest(float majorRadius, float minorRadius, const trace::TraceRay& ray);
trace::AllHits looseAll(float majorRadius, float minorRadius, const trace::TraceRay& ray);
float looseAny(float majorRadius, float minorRadius, const trace::TraceRay& ray);

}  // namespace raytorus::test
