// SPDX-License-Identifier: MIT
// A number and how far float32 arithmetic may be from it: running error analysis (Wilkinson: "Error analysis
// revisited", IMA Bulletin 22, 1986). The picture's formulas, evaluated in this type, give the bound of their
// own rounding.
//
// Each operation adds half an ulp of its result, and none where it is exact: a factor that is a power of two,
// a sum with zero, a difference of numbers within a factor of two of each other (Sterbenz). Errors that
// cancel are not seen to cancel, so a bound is never too small, and seldom more than some times too large.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace raytorus::truth {

/// Half an ulp of 1.
inline constexpr double floatRounding = 0x1p-24;

struct Rounded {
    double value = 0.0;
    double error = 0.0;  ///< what float32 has in its place lies within this of the value

    Rounded() = default;
    explicit Rounded(double exact, double within = 0.0) : value(exact), error(within) {}

    [[nodiscard]] bool isExact(double number) const { return value == number && error == 0.0; }
};

/// The result of an operation that float32 rounds.
inline Rounded afterRounding(double value, double error) {
    const double largest = std::abs(value) + error;
    const bool ordinary = largest > 0.0 && largest < std::numeric_limits<double>::infinity();
    return Rounded(value, ordinary ? error + std::ldexp(floatRounding, std::ilogb(largest)) : error);
}

inline Rounded operator-(const Rounded& x) {
    return Rounded(-x.value, x.error);
}

inline Rounded operator+(const Rounded& x, const Rounded& y) {
    if (x.isExact(0.0)) return y;
    if (y.isExact(0.0)) return x;
    const double error = x.error + y.error;
    const double a = std::abs(x.value);
    const double b = std::abs(y.value);
    const bool cancels = (x.value < 0.0) != (y.value < 0.0) && a + x.error <= 2.0 * (b - y.error) &&
                         b + y.error <= 2.0 * (a - x.error);
    return cancels ? Rounded(x.value + y.value, error) : afterRounding(x.value + y.value, error);
}
inline Rounded operator-(const Rounded& x, const Rounded& y) {
    return x + -y;
}

inline bool isPowerOfTwo(const Rounded& x) {
    int exponent = 0;
    return x.error == 0.0 && std::abs(std::frexp(x.value, &exponent)) == 0.5;
}

inline Rounded operator*(const Rounded& x, const Rounded& y) {
    const double value = x.value * y.value;
    const double error = std::abs(x.value) * y.error + std::abs(y.value) * x.error + x.error * y.error;
    return isPowerOfTwo(x) || isPowerOfTwo(y) ? Rounded(value, error) : afterRounding(value, error);
}

inline Rounded operator/(const Rounded& x, const Rounded& y) {
    const double value = x.value / y.value;
    const double least = std::abs(y.value) - y.error;
    const double error =
        least > 0.0 ? (x.error + std::abs(value) * y.error) / least : std::numeric_limits<double>::infinity();
    return isPowerOfTwo(y) ? Rounded(value, error) : afterRounding(value, error);
}

inline Rounded squareRoot(const Rounded& x) {
    const double root = std::sqrt(std::max(x.value, 0.0));
    return afterRounding(root, root - std::sqrt(std::max(x.value - x.error, 0.0)));
}

inline double toDouble(const Rounded& x) {
    return x.value;
}

/// The larger of a number and a bound; no error remains where the bound is larger for certain.
inline Rounded atLeast(const Rounded& x, double bound) {
    return x.value + x.error < bound ? Rounded(bound) : Rounded(std::max(x.value, bound), x.error);
}
template <class Real>
Real atLeast(const Real& x, double bound) {
    return x < Real(bound) ? Real(bound) : x;
}

}  // namespace raytorus::truth
