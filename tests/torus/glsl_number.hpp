// SPDX-License-Identifier: MIT
// GLSL's `float`, vec2 and vec3 over a number type of ours, for the library's own text compiled as C++: exact
// fractions, integers, 113 bits. What GLSL calls sqrt, abs, ... is found by the argument.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace raytorus::test {

/// What the type cannot do by itself: square root, floor, conversion from a literal, and to float's bits.
template <class Value>
struct NumberTraits;

template <class Value>
struct Number {
    using Traits = NumberTraits<Value>;
    Value value{};

    Number() = default;
    Number(double literal) : value(Traits::fromLiteral(literal)) {}
    static Number of(Value v) {
        Number n;
        n.value = v;
        return n;
    }

    friend Number operator+(const Number& a, const Number& b) { return of(a.value + b.value); }
    friend Number operator-(const Number& a, const Number& b) { return of(a.value - b.value); }
    friend Number operator*(const Number& a, const Number& b) { return of(a.value * b.value); }
    friend Number operator/(const Number& a, const Number& b) { return of(a.value / b.value); }
    friend Number operator-(const Number& a) { return of(-a.value); }
    friend bool operator<(const Number& a, const Number& b) { return a.value < b.value; }
    friend bool operator>(const Number& a, const Number& b) { return a.value > b.value; }
    friend bool operator<=(const Number& a, const Number& b) { return a.value <= b.value; }
    friend bool operator>=(const Number& a, const Number& b) { return a.value >= b.value; }
    friend bool operator==(const Number& a, const Number& b) { return a.value == b.value; }
    friend bool operator!=(const Number& a, const Number& b) { return a.value != b.value; }

    friend Number sqrt(const Number& x) { return of(Traits::squareRoot(x.value)); }
    friend Number floor(const Number& x) { return of(Traits::floor(x.value)); }
    friend Number abs(const Number& x) { return x.value < Value(0) ? -x : x; }
    friend Number min(const Number& a, const Number& b) { return b.value < a.value ? b : a; }
    friend Number max(const Number& a, const Number& b) { return a.value < b.value ? b : a; }
    friend Number clamp(const Number& x, const Number& low, const Number& high) {
        return min(max(x, low), high);
    }
    // Powers of two and starts of iterations are taken from the float next to the number.
    friend std::uint32_t floatBitsToUint(const Number& x) {
        return std::bit_cast<std::uint32_t>(Traits::toFloat(x.value));
    }
};

template <class Float>
struct Vector2 {
    Float x, y;
};

template <class Float>
struct Vector3 {
    Float x, y, z;

    friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector3 operator*(const Vector3& a, const Vector3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend Vector3 operator+(const Vector3& a, const Float& s) { return {a.x + s, a.y + s, a.z + s}; }
    friend Vector3 operator-(const Vector3& a, const Float& s) { return {a.x - s, a.y - s, a.z - s}; }
    friend Vector3 operator*(const Vector3& a, const Float& s) { return {a.x * s, a.y * s, a.z * s}; }
    friend Vector3 operator*(const Float& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

}  // namespace raytorus::test
