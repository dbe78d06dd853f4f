// SPDX-License-Identifier: MIT
// Where the distance to the tube's centre circle is extremal along a line. A verdict can only be in doubt
// where one of these extrema lies near the tube's surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/bracketed_root.hpp"

namespace raytorus::reference {

struct Extrema {
    std::array<double, 3> at{};
    int count = 0;
};

// The line p + u d; A = d.d, B = p.d; a and b the same of the xy parts; e = (px dy - py dx)^2, taken as that
// square and not as ac - b^2, which cancels near the axis.
//
// Half the derivative of the squared distance is h(u) = A u + B - R (a u + b) / rho(u), and
// h'(u) = A - R e / rho^3: h rises, falls between the two places where rho^3 = R e / A, and rises again.
//
// Plain double will do: the distance is stationary here, so an error of 1e-15 in u is one of 1e-30 in it.
inline Extrema tubeExtrema(double R, double A, double B, double a, double b, double e) {
    Extrema found;
    const auto h = [&](double u) {
        const double along = a * u + b;
        const double rho = std::sqrt((along * along + e) / a);
        return A * u + B - (rho > 0 ? R * along / rho : 0.0);
    };
    const auto addBracketed = [&](double low, double high) {
        const double atLow = h(low), atHigh = h(high);
        if ((atLow < 0) == (atHigh < 0)) return;
        // |u| stays below 8, where doubles are 2^-50 apart
        found.at[static_cast<std::size_t>(found.count++)] =
            bracketedRoot(h, low, atLow, high, atHigh, 0x1p-49);
    };

    if (!(a > 0)) {  // parallel to the axis
        found.at[static_cast<std::size_t>(found.count++)] = -B / A;
        return found;
    }
    // |R (a u + b) / rho| <= R sqrt(a), so h < 0 below and h > 0 above this interval; doubled for the
    // roundings.
    const double reach = 2 * R * std::sqrt(a) / A + 1e-12;
    const double first = -B / A - reach, last = -B / A + reach;
    const double rhoThere = std::cbrt(R * e / A);
    const double halfWidthSquared = (rhoThere * rhoThere - e / a) / a;
    if (!(halfWidthSquared >= 0)) {
        addBracketed(first, last);
        return found;
    }
    // On a line through the axis the falling piece is a jump; 1e-15 keeps both its sides apart.
    const double halfWidth = std::max(std::sqrt(halfWidthSquared), 1e-15);
    const double fallsFrom = std::clamp(-b / a - halfWidth, first, last);
    const double fallsTo = std::clamp(-b / a + halfWidth, first, last);
    addBracketed(first, fallsFrom);
    addBracketed(fallsFrom, fallsTo);
    addBracketed(fallsTo, last);
    return found;
}

}  // namespace raytorus::reference
