// SPDX-License-Identifier: MIT
// The reference in 113 bits: the intersection, and the surface by its definitions.
#include "reference/torus_reference.hpp"

#include "reference/intersect.hpp"

namespace raytorus::reference {

namespace {

const Quad twoPi = 8 * atanq(1);

// A point in the half plane through the axis: (cosU, sinU) points away from the axis.
struct Meridian {
    Quad rho, cosU, sinU;
    Quad fromRing, toRing;  // rho - R, and the distance to the tube's centre circle
    Quad cosV, sinV;

    Meridian(const PreciseTorus& torus, const QuadVec3& p)
        : rho(hypotq(p[0], p[1])),
          cosU(rho > 0 ? p[0] / rho : 1),
          sinU(rho > 0 ? p[1] / rho : 0),
          fromRing(rho - torus.majorRadius),
          toRing(hypotq(fromRing, p[2])),
          cosV(toRing > 0 ? fromRing / toRing : 1),
          sinV(toRing > 0 ? p[2] / toRing : 0) {}
};

// An angle in turns, in [0, 1); -0 becomes +0.
Quad turns(Quad y, Quad x) {
    const Quad turn = atan2q(y, x) / twoPi;
    const Quad wrapped = turn < 0 ? turn + 1 : turn;
    return wrapped < 1 ? wrapped + 0 : 0;
}

}  // namespace

Intersections intersect(const PreciseTorus& torus, const PreciseRay& ray) {
    return intersectAs<Quad>(torus, ray);
}

QuadVec3 normal(const PreciseTorus& torus, const QuadVec3& position) {
    const Meridian m(torus, position);
    return {m.cosV * m.cosU, m.cosV * m.sinU, m.sinV};
}

QuadVec2 uv(const PreciseTorus& torus, const QuadVec3& position) {
    const Meridian m(torus, position);
    return {m.rho > 0 ? turns(position[1], position[0]) : 0, turns(position[2], m.fromRing)};
}

QuadVec3 position(const PreciseTorus& torus, const QuadVec2& uv) {
    const Quad u = twoPi * uv[0], v = twoPi * uv[1];
    const Quad rho = torus.majorRadius + torus.minorRadius * cosq(v);
    return {rho * cosq(u), rho * sinq(u), torus.minorRadius * sinq(v)};
}

Tangents tangents(const PreciseTorus& torus, const QuadVec3& position) {
    const Meridian m(torus, position);
    const Quad perU = twoPi * (torus.majorRadius + torus.minorRadius * m.cosV);
    const Quad perV = twoPi * torus.minorRadius;
    return {{-perU * m.sinU, perU * m.cosU, 0},
            {-perV * m.sinV * m.cosU, -perV * m.sinV * m.sinU, perV * m.cosV}};
}

Quad distance(const PreciseTorus& torus, const QuadVec3& point) {
    const Meridian m(torus, point);
    const Quad R = torus.majorRadius, r = torus.minorRadius;
    // The profile is the part of a circle with rho >= 0. Inside a spindle the nearest point of the whole
    // circle may lie beyond the axis; the nearest one of the profile is then the cusp, where the profile
    // ends.
    if (R + r * m.cosV < 0) {
        const Quad cusp = sqrtq((r - R) * (r + R));
        return -hypotq(m.rho, fabsq(point[2]) - cusp);
    }
    return m.toRing - r;
}

Quad implicit(const PreciseTorus& torus, const QuadVec3& p) {
    const Quad R = torus.majorRadius, r = torus.minorRadius;
    const Quad s = dot(p, p) + R * R - r * r;
    return s * s - 4 * R * R * (p[0] * p[0] + p[1] * p[1]);
}

QuadVec3 toQuad(const float (&v)[3]) {
    return {Quad(v[0]), Quad(v[1]), Quad(v[2])};
}

std::array<double, 3> toDouble(const QuadVec3& v) {
    return {toDouble(v[0]), toDouble(v[1]), toDouble(v[2])};
}

}  // namespace raytorus::reference
