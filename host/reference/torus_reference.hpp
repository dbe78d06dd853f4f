// SPDX-License-Identifier: MIT
// The truth that the shaders are held to: ray-torus intersection and the torus' surface in 113-bit
// arithmetic, by a method of its own (quartic, Bernstein basis, Descartes' rule of signs; see intersect.hpp).
//
// Axis +z, centre at the origin. The solid is {(rho - R)^2 + z^2 <= r^2}, rho = sqrt(x^2 + y^2): for a
// spindle (r > R) its boundary is the outer sheet alone, for R = 0 it is the sphere.
#pragma once

#include <array>
#include <limits>

#include "reference/real.hpp"

namespace raytorus::reference {

struct Torus {
    float majorRadius, minorRadius;
};

// The layout of a ray file: eight floats a ray.
struct Ray {
    float origin[3];
    float tMin;
    float direction[3];
    float tMax;
};

// The same in another number type; floats become these exactly and by themselves.
template <class Real>
struct BasicTorus {
    Real majorRadius, minorRadius;

    BasicTorus(Real major, Real minor) : majorRadius(major), minorRadius(minor) {}
    BasicTorus(const Torus& torus)
        : majorRadius(static_cast<Real>(torus.majorRadius)),
          minorRadius(static_cast<Real>(torus.minorRadius)) {}
};

template <class Real>
struct BasicRay {
    Vec3<Real> origin;
    Real tMin;
    Vec3<Real> direction;
    Real tMax;

    BasicRay(const Vec3<Real>& from, Real nearest, const Vec3<Real>& towards, Real farthest)
        : origin(from), tMin(nearest), direction(towards), tMax(farthest) {}
    BasicRay(const Ray& ray) : tMin(static_cast<Real>(ray.tMin)), tMax(static_cast<Real>(ray.tMax)) {
        for (std::size_t i = 0; i < 3; ++i) {
            origin[i] = static_cast<Real>(ray.origin[i]);
            direction[i] = static_cast<Real>(ray.direction[i]);
        }
    }
};

template <class Real>
struct BasicHit {
    Real t{};
    Vec3<Real> position{};
    bool entering = false;  // from outside to inside the solid as t grows
};

template <class Real>
struct BasicIntersections {
    int count = 0;  // hits with tMin <= t <= tMax, ascending; a tangent point counts twice or not at all
    std::array<BasicHit<Real>, 4> hits{};
    bool startsInside = false;  // origin + tMin * direction lies inside the solid

    // How far the verdict is from changing, in units of minorRadius. Each is an absolute value of
    // sqrt((rho - R)^2 + z^2) - r, the signed distance to the tube.
    // clearance: the smallest at the extrema of that distance along the whole line: small means nearly
    // tangent.
    double clearance = std::numeric_limits<double>::infinity();
    // At tMin and at tMax: small means that a hit lies near the end of the interval, or just beyond it.
    double startClearance = std::numeric_limits<double>::infinity();
    double stopClearance = std::numeric_limits<double>::infinity();

    double endClearance() const { return startClearance < stopClearance ? startClearance : stopClearance; }
};

using PreciseTorus = BasicTorus<Quad>;
using PreciseRay = BasicRay<Quad>;
using Hit = BasicHit<Quad>;
using Intersections = BasicIntersections<Quad>;
using QuadVec3 = Vec3<Quad>;
using QuadVec2 = std::array<Quad, 2>;

// Every hit. No hit and infinite clearances for r <= 0, R < 0, a torus, origin or direction that is not
// finite, a zero direction, tMin > tMax or a NaN among these two.
Intersections intersect(const PreciseTorus& torus, const PreciseRay& ray);

// The surface at a point on or near it. On the axis, where u has no value, u = 0 is meant.
QuadVec3 normal(const PreciseTorus& torus, const QuadVec3& position);  // unit, outward
QuadVec2 uv(const PreciseTorus& torus, const QuadVec3& position);      // [0,1)^2
QuadVec3 position(const PreciseTorus& torus, const QuadVec2& uv);
struct Tangents {
    QuadVec3 dPdu, dPdv;
};
Tangents tangents(const PreciseTorus& torus, const QuadVec3& position);  // derivatives of position(uv)
Quad distance(const PreciseTorus& torus, const QuadVec3& point);  // to the solid's boundary, negative inside
Quad implicit(const PreciseTorus& torus, const QuadVec3& point);  // (|p|^2 + R^2 - r^2)^2 - 4 R^2 rho^2

QuadVec3 toQuad(const float (&v)[3]);
std::array<double, 3> toDouble(const QuadVec3& v);

}  // namespace raytorus::reference
