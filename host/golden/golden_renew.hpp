// SPDX-License-Identifier: MIT
// New truths for golden cases, by the reference and by name. No device is involved.
#pragma once

#include <functional>
#include <string>

#include "golden/golden_set.hpp"

namespace raytorus::golden {

struct Renewal {
    int pixels = 0;
    int marginal = 0;  ///< where the hit, the count or the colour may flip
};

/// Renders the truth of a case, writes it and its sidecar, and enters it in the manifest. Throws
/// Error{ComparisonFailed} where the reference disagrees with itself in another precision, and
/// Error{Usage} in CI or without a reason.
Renewal renew(const Set& set, const Case& row, const std::string& reason,
              const std::function<void(double)>& progress = {});

/// Throws Error{Usage} in CI, where goldens are compared with and not made, or if the reason is blank.
void requireRenewal(const std::string& reason);

}  // namespace raytorus::golden
