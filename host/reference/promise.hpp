// SPDX-License-Identifier: MIT
// What the library promises of its answers, and where it leaves them open: docs/accuracy.md, as numbers.
#pragma once

#include <algorithm>

#include "reference/torus_reference.hpp"

namespace raytorus::reference {

/// Which of the library's promises: that of plain float32 is `TORUS_FAST`.
enum class Tier { Exact, Fast };

/// A verdict is clear if no extremum of the distance to the tube along the line is nearer to the surface
/// than this part of r ...
inline constexpr double clearMargin = 1e-3;

/// ... and neither end of the ray nearer than this part of r: there the sign of the distance decides, which
/// float32 knows to some 2^-24 (R + r), thrice for good measure.
inline double clearEndMargin(const Torus& torus) {
    const double r{torus.minorRadius};
    return std::max(2e-5, 2e-7 * (double{torus.majorRadius} + r) / r);
}

/// A line touches the surface if an extremum of the distance is this near to it, in r: 113-bit rounding, and
/// some.
inline constexpr double touchMargin = 1e-24;

/// Whether two counts of a line's hits differ only by where it touches the surface: there the contract has
/// both hits or none.
constexpr bool differByTouches(double clearance, int count, int otherCount) {
    return clearance < touchMargin && (count - otherCount) % 2 == 0;
}

/// How far a position of a clear ray may be from the exact hit of the ray as given, in R + r: 2^-24 for the
/// exact position, rounded, and half as much again for all other roundings.
inline constexpr double positionBound = 9e-8;

/// The length from which on an error of a position is gross: a hundredth of r, but in a tube so thin that a
/// rounding is longer, twice the bound.
inline double grossError(const Torus& torus) {
    const double r{torus.minorRadius};
    return std::max(0.01 * r, 2 * positionBound * (double{torus.majorRadius} + r));
}

}  // namespace raytorus::reference
