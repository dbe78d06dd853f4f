// SPDX-License-Identifier: MIT
// New truths for golden cases, by the reference and by name. No device is involved.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "golden/golden_set.hpp"

namespace raytorus::golden {

struct Renewal {
    int pixels = 0;
    int marginal = 0;  ///< where the hit, the count or the colour may flip
};

/// Renders the truths of cases, and then writes them, their sidecars and the manifest, which lists them: all
/// of these files change, or none does. What cannot be read or written is found before anything is rendered.
/// Throws Error{ComparisonFailed} where the reference disagrees with itself in another precision, and as
/// requireRenewal().
/// progress: of all of it, from 0 to 1.
std::vector<Renewal> renew(const Set& set, std::span<const Case> rows, const std::string& reason,
                           const std::function<void(double)>& progress = {});

/// Puts back what a renewal that was killed in the middle has replaced. Returns whether there was one.
bool recover(const Set& set);

/// Throws Error{Usage} in CI, where goldens are compared with and not made, or if the reason is blank or not
/// UTF-8.
void requireRenewal(const std::string& reason);

}  // namespace raytorus::golden
