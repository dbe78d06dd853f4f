// SPDX-License-Identifier: MIT
// A picture held to the truth by the truth's own channels: where the margin is 1 or more, id and count are
// exact and every other value lies within its tolerance.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace raytorus::test {

/// What one tolerance says of a picture.
struct ToleranceUse {
    const char* channel;        ///< tolerance.*
    double largestRatio = 0.0;  ///< difference / tolerance of the sharp pixels; at most 1 in a right picture
    double largestTolerance = 0.0;  ///< of the sharp pixels
};

struct TruthJudgement {
    std::vector<std::string> faults;  ///< one a value that breaks the rule
    std::array<ToleranceUse, 5> tolerances{};
    double seconds = 0.0;  ///< that the truth took
    int pixels = 0;
    int doubtful = 0, doubtfulCount = 0, doubtfulColor = 0;  ///< pixels with a margin below 1
    int flipped = 0;  ///< doubtful pixels in which id or count is another one

    void add(const TruthJudgement& other);
};

/// truth: rendered with sharpness. Both with all channels of `raytorus render`.
TruthJudgement judgeByTruth(const image::Image& truth, const image::Image& actual);

}  // namespace raytorus::test
