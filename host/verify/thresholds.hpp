// SPDX-License-Identifier: MIT
// What the numbers of a ray group must hold: the library's promises.
#pragma once

#include <string>
#include <vector>

#include "reference/promise.hpp"
#include "verify/ray_group.hpp"
#include "verify/statistics.hpp"

namespace raytorus::verify {

/// What is allowed of a ray group. Of grazing rays a few may be wrong, and their hits off without bound.
struct Thresholds {
    double wrongPart = 0.0;  ///< faults, as a part of the judged rays
    double positionMax = 0.0;
    double positionP99 = 0.0;
    double surfaceMax = 0.0;
    double tP99 = 0.0;
    double tMax = 0.0;
};
Thresholds thresholdsOf(const RayGroup& group, reference::Tier tier = reference::Tier::Exact);

/// One sentence for each threshold that a ray group exceeds.
std::vector<std::string> exceededThresholds(const RayGroup& group, const Statistics& statistics,
                                            reference::Tier tier = reference::Tier::Exact);

}  // namespace raytorus::verify
