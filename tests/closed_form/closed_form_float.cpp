// SPDX-License-Identifier: MIT
// The closed form in float, with the bits of the device (-fsingle-precision-constant).
#include <cmath>

#include "torus/glsl_number.hpp"

namespace raytorus::test {

template <>
struct NumberTraits<float> {
    static float fromLiteral(double literal) { return static_cast<float>(literal); }
    static float squareRoot(float x) { return std::sqrt(x); }
    static float floor(float x) { return std::floor(x); }
    static float toFloat(float x) { return x; }
};

}  // namespace raytorus::test

#define RAYTORUS_VALUE float
#include "closed_form_cxx_body.hpp"
