// SPDX-License-Identifier: MIT
// The closed form in fractions: no rounding at all. A square root is taken where it is a fraction itself.
#include "closed_form_cxx.hpp"
#include "torus/glsl_number.hpp"

namespace raytorus::test {

template <>
struct NumberTraits<Fraction> {
    using Integer = boost::multiprecision::cpp_int;
    static Fraction fromLiteral(double literal) { return Fraction(literal); }
    static Integer integerRoot(const Integer& square) {
        const Integer root = boost::multiprecision::sqrt(square);
        if (root * root != square) {
            throw std::domain_error("the square root is no fraction");
        }
        return root;
    }
    static Fraction squareRoot(const Fraction& x) {
        return Fraction(integerRoot(numerator(x)), integerRoot(denominator(x)));
    }
    static Fraction floor(const Fraction&) { throw std::logic_error("no step of the closed form"); }
    static float toFloat(const Fraction& x) { return x.convert_to<float>(); }
};

}  // namespace raytorus::test

#define RAYTORUS_VALUE Fraction
#include "closed_form_cxx_body.hpp"
