// SPDX-License-Identifier: MIT
// The intersection behind torus_reference.hpp, for any number type of real.hpp.
//
// Lengths and the direction are scaled by powers of two, which is exact. The parameter is moved to a point of
// the line near the torus by a step of 53 bits: times a float it has 77, so that with 104 bits or more the
// new point is exact for ordinary floats, and the distance of the origin costs nothing. In the new parameter
// u, with s = |p|^2 + R^2 - r^2, the quartic is s(u)^2 - 4 R^2 rho(u)^2. It factors into (s - 2 R rho)(s + 2
// R rho): where s >= 0 its roots are the outer sheet's, where s <= 0 the inner sheet's, and the places with s
// = 0 lie inside the solid. So the quartic is only searched where s >= 0, and its sign at the ends of that
// range is known.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/extrema.hpp"
#include "reference/roots.hpp"
#include "reference/torus_reference.hpp"

namespace raytorus::reference {

// sqrt((rho - R)^2 + z^2) - r: exact distance to a tube that does not meet the axis, same sign for any torus
template <class Real>
Real tubeDistance(const BasicTorus<Real>& torus, const Vec3<Real>& p) {
    const Real rho = squareRoot(p[0] * p[0] + p[1] * p[1]);
    const Real fromRing = rho - torus.majorRadius;
    return squareRoot(fromRing * fromRing + p[2] * p[2]) - torus.minorRadius;
}

template <class Real>
bool isValid(const BasicTorus<Real>& torus, const BasicRay<Real>& ray) {
    bool finite = isFinite(torus.majorRadius) && isFinite(torus.minorRadius);
    bool moves = false;
    for (std::size_t i = 0; i < 3; ++i) {
        finite = finite && isFinite(ray.origin[i]) && isFinite(ray.direction[i]);
        moves = moves || ray.direction[i] != Real(0);
    }
    return finite && moves && torus.majorRadius >= Real(0) && torus.minorRadius > Real(0) &&
           ray.tMin <= ray.tMax;
}

// The line in units near 1: |direction| in [1, 4), the larger radius in [1, 2).
template <class Real>
struct ScaledLine {
    Vec3<Real> point, direction;
    Real shift;  // the scaled t of `point`

    Vec3<Real> at(Real u) const {
        return {point[0] + u * direction[0], point[1] + u * direction[1], point[2] + u * direction[2]};
    }
};

template <class Real>
ScaledLine<Real> shiftedToFoot(const Vec3<Real>& origin, const Vec3<Real>& direction) {
    ScaledLine<Real> line{origin, direction, Real(0)};
    const Real lengthSquared = dot(direction, direction);
    // One round reaches the foot within 2^-53 of the distance; more are for origins beyond 1e12 radii.
    for (int round = 0; round < 8; ++round) {
        const double toFoot = toDouble(-dot(line.point, direction) / lengthSquared);
        if (!(std::abs(toFoot) > 1.0 / 1024)) break;
        const Real step(toFoot);
        line.point = line.at(step);
        line.shift = line.shift + step;
    }
    return line;
}

// The coefficients of s(u) = A u^2 + 2 B u + C and of rho(u)^2 = a u^2 + 2 b u + c.
template <class Real>
struct LineForms {
    Real A, B, C, a, b, c;

    LineForms(const BasicTorus<Real>& torus, const Vec3<Real>& p, const Vec3<Real>& d)
        : A(dot(d, d)),
          B(dot(p, d)),
          C(dot(p, p) + torus.majorRadius * torus.majorRadius - torus.minorRadius * torus.minorRadius),
          a(d[0] * d[0] + d[1] * d[1]),
          b(p[0] * d[0] + p[1] * d[1]),
          c(p[0] * p[0] + p[1] * p[1]) {}
};

// Adds the roots of `q` between two points of which those marked so are known to lie inside the solid.
template <class Real>
void addRootsBetween(const Quartic<Real>& q, Real low, bool lowInside, Real high, bool highInside,
                     RootList<Real>& found) {
    if (!(low < high)) return;
    Quartic<Real> b = toBernstein(q, low, high - low);
    // The sign is certain where rounding may have lost it, at a cusp of a spindle: far below any other
    // number.
    const Real hardlyNegative(-1e-300);
    if (lowInside && !(b[0] < Real(0))) b[0] = hardlyNegative;
    if (highInside && !(b[4] < Real(0))) b[4] = hardlyNegative;
    isolate(b, low, high - low, maximumDepth<Real>, found);
}

// All outer roots on the line.
template <class Real>
RootList<Real> lineRoots(const BasicTorus<Real>& torus, const LineForms<Real>& f) {
    RootList<Real> found;
    const Real R = torus.majorRadius;
    const Real discriminant = f.B * f.B - f.A * f.C;
    const bool meetsInnerSphere = discriminant >= Real(0);  // somewhere s <= 0
    const Real spread = meetsInnerSphere ? squareRoot(discriminant) : Real(0);
    const Real sBegin = (-f.B - spread) / f.A, sEnd = (-f.B + spread) / f.A;
    if (R == Real(0)) {  // s is the sphere itself and the quartic its square
        if (!meetsInnerSphere) return found;
        found.add(sBegin, true);
        found.add(sEnd, false);
        return found;
    }
    // Outside the bounding sphere there are no roots; a generous multiple of 1/64, so that halvings are
    // exact.
    const double reach = toDouble((R + torus.minorRadius) / squareRoot(f.A) + magnitude(f.B) / f.A);
    const Real end(std::ceil(reach * 64 + 1) / 64);
    const Real k = Real(4) * R * R;
    const Quartic<Real> q{f.C * f.C - k * f.c, Real(4) * f.B * f.C - Real(2) * k * f.b,
                          Real(4) * f.B * f.B + Real(2) * f.A * f.C - k * f.a, Real(4) * f.A * f.B,
                          f.A * f.A};
    if (meetsInnerSphere) {
        addRootsBetween(q, -end, false, sBegin, true, found);
        addRootsBetween(q, sEnd, true, end, false, found);
    } else {
        addRootsBetween(q, -end, false, end, false, found);
    }
    dropSpuriousPairs(found);
    return found;
}

// Reduced in Real, solved in Solving: the distance of the origin is Real's business alone, since the line
// near the torus is made of numbers of the torus' size.
template <class Real, class Solving = Real>
BasicIntersections<Solving> intersectAs(const BasicTorus<Real>& torus, const BasicRay<Real>& ray) {
    BasicIntersections<Solving> result;
    if (!isValid(torus, ray)) return result;

    // Scale: p = 2^length p', d = 2^speed d', hence t = 2^(length - speed) t'.
    const int length = exponentOf(std::max(torus.majorRadius, torus.minorRadius));
    Real largest(0);
    for (const Real& component : ray.direction)
        largest = std::max(largest, magnitude(component));
    const int speed = exponentOf(largest);
    Vec3<Real> origin, direction;
    for (std::size_t i = 0; i < 3; ++i) {
        origin[i] = timesPowerOfTwo(ray.origin[i], -length);
        direction[i] = timesPowerOfTwo(ray.direction[i], -speed);
    }
    const ScaledLine<Real> exactLine = shiftedToFoot(origin, direction);
    const BasicTorus<Solving> unit(convert<Solving>(timesPowerOfTwo(torus.majorRadius, -length)),
                                   convert<Solving>(timesPowerOfTwo(torus.minorRadius, -length)));
    const ScaledLine<Solving> line{convert<Solving>(exactLine.point), convert<Solving>(exactLine.direction),
                                   convert<Solving>(exactLine.shift)};
    const LineForms<Solving> forms(unit, line.point, line.direction);
    const Solving start = convert<Solving>(timesPowerOfTwo(ray.tMin, speed - length) - exactLine.shift);
    const Solving stop = convert<Solving>(timesPowerOfTwo(ray.tMax, speed - length) - exactLine.shift);

    const RootList<Solving> found = lineRoots(unit, forms);
    for (int i = 0; i < found.count; ++i) {
        const Root<Solving>& root = found.roots[static_cast<std::size_t>(i)];
        if (!(root.value >= start && root.value <= stop)) continue;
        BasicHit<Solving>& hit = result.hits[static_cast<std::size_t>(result.count++)];
        hit.t = timesPowerOfTwo(line.shift + root.value, length - speed);
        hit.position = line.at(root.value);
        for (Solving& component : hit.position)
            component = timesPowerOfTwo(component, length);
        hit.entering = root.falling;
    }

    const auto signedClearance = [&](Solving u) {
        return isFinite(u) ? toDouble(tubeDistance(unit, line.at(u)) / unit.minorRadius)
                           : std::numeric_limits<double>::infinity();
    };
    const double atStart = signedClearance(start);
    result.startsInside = atStart < 0;
    result.startClearance = std::abs(atStart);
    result.stopClearance = std::abs(signedClearance(stop));
    const Solving moment = line.point[0] * line.direction[1] - line.point[1] * line.direction[0];
    const Extrema extrema = tubeExtrema(toDouble(unit.majorRadius), toDouble(forms.A), toDouble(forms.B),
                                        toDouble(forms.a), toDouble(forms.b), toDouble(moment * moment));
    for (int i = 0; i < extrema.count; ++i) {
        const Solving u(extrema.at[static_cast<std::size_t>(i)]);
        result.clearance = std::min(result.clearance, std::abs(signedClearance(u)));
    }
    return result;
}

}  // namespace raytorus::reference
