// SPDX-License-Identifier: MIT
// Vectors of any number type of the reference, and of Rounded.
#pragma once

#include "reference/double_double.hpp"
#include "reference/real.hpp"
#include "scene_io.h"
#include "truth/rounded.hpp"

namespace raytorus::truth {

using reference::dot;
using reference::DoubleDouble;
using reference::Quad;
using reference::squareRoot;
using reference::toDouble;
using reference::Vec3;

template <class Real>
Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a) {
    return {-a[0], -a[1], -a[2]};
}
template <class Real>
Vec3<Real> operator*(const Real& s, const Vec3<Real>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <class Real>
Vec3<Real> operator*(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

template <class Real>
Vec3<Real> unit(const Vec3<Real>& a) {
    const Real length = squareRoot(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

inline double length(const Vec3<double>& a) {
    return std::sqrt(dot(a, a));
}
/// The length of the vector of errors: how far the point or the tip of the vector may be off.
inline double errorLength(const Vec3<Rounded>& a) {
    return length({a[0].error, a[1].error, a[2].error});
}

template <class Real>
Vec3<Real> uniform(double s) {
    return {Real(s), Real(s), Real(s)};
}

/// A number of the scene, exactly.
template <class Real>
Real exactly(float x) {
    return Real(static_cast<double>(x));
}
template <class Real>
Vec3<Real> exactly(const scene_io::vec4& v) {
    return {exactly<Real>(v.x), exactly<Real>(v.y), exactly<Real>(v.z)};
}

template <class Real>
Vec3<double> toDoubles(const Vec3<Real>& v) {
    return {toDouble(v[0]), toDouble(v[1]), toDouble(v[2])};
}
template <class Real>
Vec3<Real> fromDoubles(const Vec3<double>& v) {
    return {Real(v[0]), Real(v[1]), Real(v[2])};
}

}  // namespace raytorus::truth
