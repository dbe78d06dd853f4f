// SPDX-License-Identifier: MIT
// sRGB by its 255 rounding limits: no pow() a pixel, and no question how a result near a limit is rounded. A
// table says where among them to begin.
#include "image/srgb.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace raytorus::image {

namespace {

// IEC 61966-2-1, from the stored value in [0,1] to linear light.
double decode(double stored) {
    return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

// Element k is the linear value whose encoding lies halfway between the 8 bit values k and k + 1. None of
// them is a float (the nearest is 2.8e-11 of its size away), so double is exact enough and ties do not arise.
// The two pieces of the function meet between 10 and 10.5: the gap the standard leaves there holds no limit.
std::array<double, 255> roundingLimits() {
    std::array<double, 255> limits{};
    for (std::size_t k = 0; k < limits.size(); ++k) {
        limits[k] = decode((static_cast<double>(k) + 0.5) / 255.0);
    }
    return limits;
}

// Floats by the 16 bits of sign, exponent and 7 of the fraction: from the one before the first limit to 1.
constexpr std::uint32_t bucketBits = 16;
constexpr std::uint32_t firstBucket = std::bit_cast<std::uint32_t>(0x1p-14F) >> bucketBits;
constexpr std::uint32_t endBucket = std::bit_cast<std::uint32_t>(1.0F) >> bucketBits;

struct Encoding {
    Encoding() {
        for (std::uint32_t bucket = firstBucket; bucket < endBucket; ++bucket) {
            const auto least = std::bit_cast<float>(bucket << bucketBits);
            const auto above = std::ranges::upper_bound(limits, static_cast<double>(least));
            below[bucket - firstBucket] = static_cast<std::uint8_t>(above - limits.begin());
        }
    }
    std::array<double, 255> limits = roundingLimits();
    std::array<std::uint8_t, endBucket - firstBucket> below{};  // limits up to the least float of a bucket
};

}  // namespace

std::uint8_t encodeSrgb(float linear) {
    static const Encoding encoding;
    const std::uint32_t bucket = std::bit_cast<std::uint32_t>(linear) >> bucketBits;
    if (!(linear >= 0x1p-14F)) {
        return 0;
    }
    if (bucket >= endBucket) {
        return 255;
    }
    std::uint8_t code = encoding.below[bucket - firstBucket];
    while (code < 255 && encoding.limits[code] <= static_cast<double>(linear)) {
        ++code;  // most buckets hold no limit, and few hold two
    }
    return code;
}

float decodeSrgb(std::uint8_t stored) {
    return static_cast<float>(decode(stored / 255.0));
}

std::uint8_t encodeLinear(float value) {
    const double scaled = std::clamp(static_cast<double>(value), 0.0, 1.0) * 255.0;
    return static_cast<std::uint8_t>(scaled + 0.5);  // exact, and so is the rounding
}

}  // namespace raytorus::image
