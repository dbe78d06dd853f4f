// SPDX-License-Identifier: MIT
// What a picture's channels promise each other, whatever is in the picture.
#pragma once

#include <string>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace raytorus::test {

/// A sentence about the first pixel whose position is not on the torus that its id names; empty if there is
/// none. From far away this is sharper than any truth: rounding the ray moves a hit along the surface, by
/// 2^-24 of its distance, but never off it.
std::string offTheTori(const image::Image& picture, const scene::Scene& scene);

}  // namespace raytorus::test
