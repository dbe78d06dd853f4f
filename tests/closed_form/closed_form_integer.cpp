// SPDX-License-Identifier: MIT
// The closed form in integers, for its polynomials at very many points: neither divisions nor roots.
#include "torus/glsl_number.hpp"

namespace raytorus::test {

template <>
struct NumberTraits<std::int64_t> {
    static std::int64_t fromLiteral(double literal) { return static_cast<std::int64_t>(literal); }
    static std::int64_t squareRoot(std::int64_t) { throw std::logic_error("no polynomial"); }
    static std::int64_t floor(std::int64_t) { throw std::logic_error("no polynomial"); }
    static float toFloat(std::int64_t) { throw std::logic_error("no polynomial"); }
};

}  // namespace raytorus::test

#define RAYTORUS_VALUE std::int64_t
#include "closed_form_cxx_body.hpp"
