// SPDX-License-Identifier: MIT
// The floats that are not numbers on a ruler.
#pragma once

#include <limits>

namespace raytorus {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

}  // namespace raytorus
