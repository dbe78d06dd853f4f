// SPDX-License-Identifier: MIT
// Every real root of a ray's quartic in 113 bits, both sheets of a spindle, by another method than the closed
// form's: Descartes' rule of signs in the Bernstein basis; and how far a list of roots is from another.
#pragma once

#include <limits>
#include <vector>

#include "closed_form_cxx.hpp"
#include "reference/intersect.hpp"
#include "reference/torus_reference.hpp"

namespace raytorus::test {

using reference::Quad;

inline Triple<Quad> quads(const float (&v)[3]) {
    return {Quad(v[0]), Quad(v[1]), Quad(v[2])};
}

/// t of the roots, ascending. The polynomial is that of the implicit equation, written from its two squares.
inline std::vector<Quad> allRoots(const reference::Torus& torus, const Triple<Quad>& origin,
                                  const Triple<Quad>& direction) {
    using namespace reference;
    // Directions down to 1e-18 long: a power of two takes them to about 1.
    const int speed = exponentOf(squareRoot(dot(direction, direction)));
    Triple<Quad> d = direction;
    for (Quad& component : d) {
        component = timesPowerOfTwo(component, -speed);
    }
    const ScaledLine<Quad> line = shiftedToFoot<Quad>(origin, d);
    const PreciseTorus precise(torus);
    const LineForms<Quad> f(precise, line.point, line.direction);
    const Quad k = 4 * precise.majorRadius * precise.majorRadius;
    const reference::Quartic<Quad> q{f.C * f.C - k * f.c, 4 * f.B * f.C - 2 * k * f.b,
                                     4 * f.B * f.B + 2 * f.A * f.C - k * f.a, 4 * f.A * f.B, f.A * f.A};
    // All roots are nearer to the foot than R + r. No round number: a multiple root in the middle of the
    // interval, as symmetry likes it, would be a point of subdivision.
    const Quad end = 1.0625 * (precise.majorRadius + precise.minorRadius) / squareRoot(f.A) + 0.01;
    RootList<Quad> found;
    isolate(toBernstein(q, -end, Quad(2.03) * end), -end, Quad(2.03) * end, maximumDepth<Quad>, found);
    dropSpuriousPairs(found);
    std::vector<Quad> roots;
    for (int i = 0; i < found.count; ++i) {
        roots.push_back(timesPowerOfTwo(line.shift + found.roots[static_cast<std::size_t>(i)].value, -speed));
    }
    return roots;
}

struct RootsDifference {
    double pairs = 0;   ///< the widest pair that only one of the lists has; infinite if they differ otherwise
    double values = 0;  ///< the largest difference of the roots that both have
};

/// A tangent's pair may be in one list and not in the other: the closest pairs of the longer one are left
/// out.
inline RootsDifference difference(std::vector<Quad> a, std::vector<Quad> b, Quad unit) {
    RootsDifference result;
    if (a.size() < b.size()) {
        std::swap(a, b);
    }
    if ((a.size() - b.size()) % 2 != 0) {
        return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    while (a.size() > b.size()) {
        std::size_t closest = 0;
        for (std::size_t i = 1; i + 1 < a.size(); ++i) {
            if (a[i + 1] - a[i] < a[closest + 1] - a[closest]) {
                closest = i;
            }
        }
        result.pairs = std::max(result.pairs, static_cast<double>((a[closest + 1] - a[closest]) / unit));
        const auto at = a.begin() + static_cast<std::ptrdiff_t>(closest);
        a.erase(at, at + 2);
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        result.values =
            std::max(result.values, static_cast<double>(reference::magnitude(a[i] - b[i]) / unit));
    }
    return result;
}

}  // namespace raytorus::test
