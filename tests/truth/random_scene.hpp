// SPDX-License-Identifier: MIT
// Scenes at random: tori of every thickness, anywhere, seen from near, far, inside and along the surface.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace raytorus::test {

struct RandomScene {
    std::string description;  ///< what was drawn, for messages
    scene::Scene scene;
};

RandomScene randomScene(std::uint64_t seed, std::uint64_t index);

}  // namespace raytorus::test
