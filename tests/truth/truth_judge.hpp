// SPDX-License-Identifier: MIT
// A picture held to the truth as the goldens are, by compare::compare, and what many such comparisons come
// to.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace raytorus::test {

/// What one tolerance says of a picture.
struct ToleranceUse {
    const char* tolerance = "";  ///< "color" for tolerance.color
    double largestRatio = 0.0;   ///< difference / tolerance of the sharp pixels; at most 1 in a right picture
};

struct TruthJudgement {
    std::vector<std::string> faults;  ///< one a channel in which a value breaks the rule
    std::array<ToleranceUse, 5> uses{};
    double seconds = 0.0;  ///< that the truth took
    std::int64_t pixels = 0;
    std::int64_t doubtful = 0, doubtfulCount = 0, doubtfulColor = 0;  ///< pixels with a margin below 1
    std::int64_t flipped = 0;  ///< doubtful pixels in which a value is off by more than its tolerance

    void add(const TruthJudgement& other);
};

/// truth: rendered with sharpness. Both with all channels of `raytorus render`.
TruthJudgement judgeByTruth(const image::Image& truth, const image::Image& actual);

}  // namespace raytorus::test
