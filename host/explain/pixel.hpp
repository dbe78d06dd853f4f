// SPDX-License-Identifier: MIT
// A ray named by the pixel of a scene that it belongs to.
#pragma once

#include <string>

#include "reference/torus_reference.hpp"
#include "scene/scene.hpp"

namespace raytorus::explain {

struct PixelRay {
    int x = 0, y = 0;
    std::size_t index = 0;  ///< of the torus, in the scene
    reference::Torus torus{};
    reference::Ray ray{};  ///< in the torus' frame, as the shaders have it
    bool hits = false;
    std::string sentence;  ///< which torus, and why this one: "torus 3, which the ray hits first"
};

/// The ray through a pixel, and the torus that it hits first, or else the one that it passes nearest to. The
/// scene has a torus; the pixel is counted from the upper left corner.
PixelRay pixelRay(const scene::Scene& scene, int width, int height, int x, int y);

}  // namespace raytorus::explain
