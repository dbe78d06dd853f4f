// SPDX-License-Identifier: MIT
// The sRGB transfer function of IEC 61966-2-1 between linear light and 8 bit values.
#pragma once

#include <cstdint>

namespace raytorus::image {

/// The 8 bit sRGB value nearest to this linear one, correctly rounded. Below 0 gives 0, above 1 gives 255.
[[nodiscard]] std::uint8_t encodeSrgb(float linear);

/// The linear value of an 8 bit sRGB one. encodeSrgb() gives the same 8 bits back.
[[nodiscard]] float decodeSrgb(std::uint8_t stored);

/// The 8 bit value nearest to 255 times this one, for what is not colour (alpha). Clamped like encodeSrgb().
[[nodiscard]] std::uint8_t encodeLinear(float value);

}  // namespace raytorus::image
