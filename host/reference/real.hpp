// SPDX-License-Identifier: MIT
// The number types of the reference, and the few functions it needs of each: 113 bits (Quad) is the arbiter,
// long double a cross-check. A further type joins by giving the same functions.
#pragma once

#include <quadmath.h>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace raytorus::reference {

// IEEE binary128. `__extension__`: it is no standard C++ type and -Wpedantic would say so at every use.
__extension__ typedef __float128 Quad;

template <class Real>
using Vec3 = std::array<Real, 3>;

template <class Real>
inline constexpr int mantissaBits = std::numeric_limits<Real>::digits;
template <>
inline constexpr int mantissaBits<Quad> = FLT128_MANT_DIG;

inline Quad squareRoot(Quad x) {
    return sqrtq(x);
}
inline double squareRoot(double x) {
    return std::sqrt(x);
}
inline long double squareRoot(long double x) {
    return std::sqrt(x);
}

// x * 2^exponent, exact
inline Quad timesPowerOfTwo(Quad x, int exponent) {
    return ldexpq(x, exponent);
}
inline double timesPowerOfTwo(double x, int exponent) {
    return std::ldexp(x, exponent);
}
inline long double timesPowerOfTwo(long double x, int exponent) {
    return std::ldexp(x, exponent);
}

// the e with 2^e <= |x| < 2^(e+1), for finite x other than 0
inline int exponentOf(Quad x) {
    return ilogbq(x);
}
inline int exponentOf(double x) {
    return std::ilogb(x);
}
inline int exponentOf(long double x) {
    return std::ilogb(x);
}

inline double toDouble(Quad x) {
    return static_cast<double>(x);
}
inline double toDouble(double x) {
    return x;
}
inline double toDouble(long double x) {
    return static_cast<double>(x);
}

// Rounds to a type of fewer bits, or keeps the type.
template <class To, class From>
To convert(const From& x) {
    if constexpr (std::is_same_v<To, From>) {
        return x;
    } else {
        return static_cast<To>(toDouble(x));
    }
}
template <class To, class From>
Vec3<To> convert(const Vec3<From>& v) {
    return {convert<To>(v[0]), convert<To>(v[1]), convert<To>(v[2])};
}

template <class Real>
Real magnitude(Real x) {
    return x < Real(0) ? -x : x;
}

// False for NaN and for the infinities, whose difference with themselves is NaN.
template <class Real>
bool isFinite(Real x) {
    return x - x == Real(0);
}

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace raytorus::reference
