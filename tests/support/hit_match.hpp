// SPDX-License-Identifier: MIT
// Holds the three answers to one ray to the reference, however near the ray is to a tangent and its ends to
// the surface: what is certain must be so, and what may go either way must go one of the ways the contract
// allows.
#pragma once

#include <string>

#include "judge/queries.hpp"
#include "reference/rays.hpp"

namespace raytorus::test {

/// What is wrong; empty if nothing is. A hit nearest to an end of the ray that lies within clearEndMargin of
/// the surface (see verify/judge.hpp) may be there or not. Where the line comes nearer to touching the
/// surface than tangentMargin, so may pairs of hits: then each hit must lie on the surface and at its t,
/// their number must be even or odd as it should, and the three functions must agree.
std::string mismatch(const reference::Torus& torus, const reference::Ray& ray, const judge::Answers& answers);

/// Whether the answers have the form that the contract gives them, right or wrong: finite, ascending, within
/// the ray, and filled where there is no hit. Empty if they have.
std::string malformed(const reference::Ray& ray, const judge::Answers& answers);

/// Of R + r. The line is known to some 2^-40 of it, four times for the sum of a point's three coordinates.
inline constexpr double tangentMargin = 0x1p-38;

}  // namespace raytorus::test
