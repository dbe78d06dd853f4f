// SPDX-License-Identifier: MIT
// Images made fit to be looked at, as text that a page can hold.
#pragma once

#include <string>

#include "image/image.hpp"

namespace raytorus::report {

/// R, G, B of an image, with magenta where one of them is not finite. An image without R, G and B is shown by
/// its first channel in grey; black and white are the smallest and largest finite value of that of `scale`.
[[nodiscard]] image::Image displayImage(const image::Image& image, const image::Image& scale);

/// "data:image/png;base64,...": the R, G, B of an image, pixel for pixel.
[[nodiscard]] std::string pngDataUri(const image::Image& image);

}  // namespace raytorus::report
