// SPDX-License-Identifier: MIT
// The closed form in 113 bits: what the formulas give when rounding is out of the way.
#include "reference/real.hpp"
#include "torus/glsl_number.hpp"

namespace raytorus::test {

template <>
struct NumberTraits<reference::Quad> {
    using Quad = reference::Quad;
    static Quad fromLiteral(double literal) { return literal; }
    static Quad squareRoot(Quad x) { return sqrtq(x); }
    static Quad floor(Quad x) { return floorq(x); }
    static float toFloat(Quad x) { return static_cast<float>(x); }
};

}  // namespace raytorus::test

#define RAYTORUS_VALUE reference::Quad
#include "closed_form_cxx_body.hpp"
