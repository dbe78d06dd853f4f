// SPDX-License-Identifier: MIT
// Real roots of a quartic on an interval, isolated by Descartes' rule of signs in the Bernstein basis.
//
// Collins, Akritas: "Polynomial real root isolation using Descartes' rule of signs", SYMSAC 1976;
// Lane, Riesenfeld: "Bounds on a polynomial", BIT 21, 1981 (the Bernstein form of it).
#pragma once

#include <algorithm>
#include <array>

#include "reference/bracketed_root.hpp"
#include "reference/real.hpp"

namespace raytorus::reference {

// Coefficients c[0] + c[1] u + ... + c[4] u^4 (power basis), or of the Bernstein polynomials B(0,4) ...
// B(4,4).
template <class Real>
using Quartic = std::array<Real, 5>;

template <class Real>
struct Root {
    Real value{};
    bool falling = false;  // the polynomial goes from positive to negative here
};

// At most four roots an interval, in ascending order; room for two intervals.
template <class Real>
struct RootList {
    std::array<Root<Real>, 8> roots{};
    int count = 0;

    void add(Real value, bool falling) { roots[static_cast<std::size_t>(count++)] = {value, falling}; }
};

// A quartic has four roots; where two intervals meet at a double root, roundings may add a pair. It is the
// closest.
template <class Real>
void dropSpuriousPairs(RootList<Real>& found) {
    const auto begin = found.roots.begin();
    while (found.count > 4) {
        auto closest = begin;
        for (auto i = begin; i + 1 < begin + found.count; ++i) {
            if ((i + 1)->value - i->value < (closest + 1)->value - closest->value) closest = i;
        }
        std::copy(closest + 2, begin + found.count, closest);
        found.count -= 2;
    }
}

// The Bernstein coefficients of q(low + width v), v in [0, 1].
template <class Real>
Quartic<Real> toBernstein(Quartic<Real> q, Real low, Real width) {
    // Taylor shift by repeated synthetic division, then the unit of v.
    for (std::size_t first = 0; first < 4; ++first) {
        for (std::size_t i = 4; i-- > first;)
            q[i] = q[i] + low * q[i + 1];
    }
    Real power = width;
    for (std::size_t i = 1; i < 5; ++i) {
        q[i] = q[i] * power;
        power = power * width;
    }
    // b[j] = sum over i of C(j,i) / C(4,i) q[i]: with q[i] divided by C(4,i) these are repeated sums.
    q[1] = q[1] * Real(0.25);
    q[2] = q[2] / Real(6);
    q[3] = q[3] * Real(0.25);
    for (std::size_t first = 0; first < 4; ++first) {
        for (std::size_t i = 4; i > first; --i)
            q[i] = q[i] + q[i - 1];
    }
    return q;
}

// Sign changes of the coefficients. Zero counts as positive everywhere: as if an infinitesimal constant were
// added to the polynomial, which adds the same constant to each Bernstein coefficient. So a root that falls
// on a point of subdivision is seen by exactly one neighbour, and the parity of the count is always sound.
template <class Real>
int signChanges(const Quartic<Real>& b) {
    int changes = 0;
    for (std::size_t i = 1; i < 5; ++i)
        changes += (b[i - 1] < Real(0)) != (b[i] < Real(0)) ? 1 : 0;
    return changes;
}

// The one root in [0, 1] where b[0] and b[4] differ in sign.
template <class Real>
Real refine(const Quartic<Real>& b) {
    const Quartic<Real> q{b[0], Real(4) * (b[1] - b[0]), Real(6) * (b[2] - Real(2) * b[1] + b[0]),
                          Real(4) * (b[3] - b[0] + Real(3) * (b[1] - b[2])),
                          b[4] + b[0] - Real(4) * (b[1] + b[3]) + Real(6) * b[2]};
    const auto value = [&](Real x) { return q[0] + x * (q[1] + x * (q[2] + x * (q[3] + x * q[4]))); };
    const Real lastPlaces = timesPowerOfTwo(Real(1), 2 - mantissaBits<Real>);
    return bracketedRoot(value, Real(0), b[0], Real(1), b[4], lastPlaces);
}

// Adds the roots in [low, low + width]. `depth` halvings remain; roots that they cannot part are one root of
// that multiplicity. An even one is reported as a pair (a tangent: both roots), an odd one as a single
// crossing.
template <class Real>
void isolate(const Quartic<Real>& b, Real low, Real width, int depth, RootList<Real>& found) {
    const int changes = signChanges(b);
    if (changes == 0) return;
    const bool falling = !(b[0] < Real(0));
    if (changes == 1) {
        found.add(low + width * refine(b), falling);
        return;
    }
    if (depth == 0) {
        found.add(low + width * Real(0.5), falling);
        if (changes % 2 == 0) found.add(low + width * Real(0.5), !falling);
        return;
    }
    // de Casteljau at the midpoint; its roundings are relative to the coefficients at hand, so no depth adds
    // noise
    Quartic<Real> left = b, right = b;
    for (std::size_t level = 0; level < 4; ++level) {
        left[level] = right[0];
        for (std::size_t i = 0; i < 4 - level; ++i)
            right[i] = (right[i] + right[i + 1]) * Real(0.5);
    }
    left[4] = right[0];
    const Real half = width * Real(0.5);
    isolate(left, low, half, depth - 1, found);
    isolate(right, low + half, half, depth - 1, found);
}

// Two roots closer than 2^-(bits/2) are beyond the polynomial's own rounding, which is squared there; the 8
// more halvings cover the length of the starting interval.
template <class Real>
inline constexpr int maximumDepth = mantissaBits<Real> / 2 + 8;

}  // namespace raytorus::reference
