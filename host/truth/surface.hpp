// SPDX-License-Identifier: MIT
// What is seen where a ray hits a torus: position, outward normal and uv, from the hit in the torus' frame.
#pragma once

#include <cmath>
#include <numbers>

#include "truth/scene_data.hpp"

namespace raytorus::truth {

template <class Real>
struct SurfacePoint {
    Vec3<Real> position, outward;  // in the world
    std::array<Real, 2> uv;        // in turns
};

/// What the library promises of an angle besides the rounding of its arguments: 1e-7 of a turn.
inline constexpr double turnRounding = 1e-7;

/// The angle of (x, y), in turns from 0 to 1.
inline double turns(double y, double x) {
    const double turn = std::atan2(y, x) / (2.0 * std::numbers::pi);
    const double wrapped = turn < 0.0 ? turn + 1.0 : turn;
    return wrapped < 1.0 ? wrapped : 0.0;
}
inline Rounded turns(const Rounded& y, const Rounded& x) {
    const double radius2 = x.value * x.value + y.value * y.value;
    const double across = std::abs(x.value) * y.error + std::abs(y.value) * x.error;
    const double angle = across > 0.0 ? across / (2.0 * std::numbers::pi * radius2) : 0.0;
    return Rounded(turns(y.value, x.value), std::min(angle, 0.5) + turnRounding);
}

/// Normal and uv in the torus' frame, for double and Rounded.
template <class Real>
SurfacePoint<Real> inTorusFrame(const scene_io::SceneTorus& torus, const Vec3<Real>& p) {
    const Real rho = squareRoot(p[0] * p[0] + p[1] * p[1]);
    const Real fromRing = rho - exactly<Real>(torus.radii.x);
    const Real toRing = squareRoot(fromRing * fromRing + p[2] * p[2]);
    const Real radial = fromRing / toRing;
    const bool onAxis = !(toDouble(rho) > 0.0);
    const Real perRho = onAxis ? radial : radial / rho;
    return {p,
            {onAxis ? radial : p[0] * perRho, p[1] * perRho, p[2] / toRing},
            {turns(p[1], p[0]), turns(p[2], fromRing)}};
}
/// In 113 bits the reference says it.
inline SurfacePoint<Quad> inTorusFrame(const scene_io::SceneTorus& torus, const Vec3<Quad>& p) {
    const reference::PreciseTorus shape(shapeOf(torus));
    return {p, reference::normal(shape, p), reference::uv(shape, p)};
}

/// The same in the world.
template <class Real>
SurfacePoint<Real> surfacePoint(const scene_io::SceneTorus& torus, const Vec3<Real>& hit) {
    const SurfacePoint<Real> local = inTorusFrame(torus, hit);
    return {fromTorus(torus, local.position) + originOf<Real>(torus), fromTorus(torus, local.outward),
            local.uv};
}

/// Between two angles in turns, the shorter way round.
inline double turnsBetween(double a, double b) {
    const double apart = std::abs(a - b);
    return std::min(apart, 1.0 - apart);
}

}  // namespace raytorus::truth
