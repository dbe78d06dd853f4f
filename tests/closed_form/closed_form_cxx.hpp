// SPDX-License-Identifier: MIT
// shaders/torus/closed_form.glsl as C++ over a number type: float for the device's bits, Quad (113 bits) to
// see the formulas without their rounding, exact fractions and integers to prove identities with.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

#include "reference/real.hpp"

namespace raytorus::test {

using Fraction =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

template <class Value>
using Triple = std::array<Value, 3>;

template <class Value>
struct ReducedRay {
    Triple<Value> origin{}, direction{};
    Value tubeRadius{}, shift{}, scale{};
};

template <class Value>
struct ReducedQuartic {
    Value alpha{}, cz{}, beta{};
};

template <class Value>
struct QuarticRoots {
    int count = 0;
    std::array<Value, 4> roots{};
};

/// The functions of closed_form.glsl, by their names without `torus`.
template <class Value>
struct ClosedFormCxx {
    using Ray = ReducedRay<Value>;
    using Quartic = ReducedQuartic<Value>;
    using Roots = QuarticRoots<Value>;

    static std::array<Value, 5> quarticCoefficients(Value majorRadius, Value minorRadius,
                                                    const Triple<Value>& origin,
                                                    const Triple<Value>& direction);
    static bool reduceRay(Value majorRadius, Value minorRadius, const Triple<Value>& origin,
                          const Triple<Value>& direction, Ray& reduced);
    static Value betaSum(const Ray& ray);
    static Value betaProduct(const Ray& ray);
    static Quartic axialQuartic(const Ray& ray);
    static Quartic radialQuartic(const Ray& ray);
    static Roots reducedRoots(const Quartic& quartic);
    static Roots reducedRootsUnhalved(const Quartic& quartic);
    static Roots closedFormRoots(Value majorRadius, Value minorRadius, const Triple<Value>& origin,
                                 const Triple<Value>& direction);
};

extern template struct ClosedFormCxx<float>;
extern template struct ClosedFormCxx<reference::Quad>;
extern template struct ClosedFormCxx<Fraction>;
extern template struct ClosedFormCxx<std::int64_t>;

}  // namespace raytorus::test
