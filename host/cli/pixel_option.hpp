// SPDX-License-Identifier: MIT
// A ray named by the pixel of a scene that it belongs to.
#pragma once

#include <string>

#include "explain/pixel.hpp"

namespace raytorus::cli {

/// The ray through a pixel, and the torus that it hits first, or else the one that it passes nearest to.
///
/// pixel      "X,Y", from the upper left corner
/// size       "WIDTHxHEIGHT" instead of the scene's; may be empty
/// Throws Error{Usage} for a pixel outside the picture, and what readScene throws.
explain::PixelRay pixelRay(const std::string& scenePath, const std::string& pixel, const std::string& size);

}  // namespace raytorus::cli
