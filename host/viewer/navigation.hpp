// SPDX-License-Identifier: MIT
// How a hand moves a camera. Pure mathematics on scene::Camera: no window, no device.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace raytorus::viewer {

/// Turns the camera round its target: `across` radians round the axis of `up` and `upwards` over it. Never
/// over the poles: it stops short of them.
scene::Camera orbit(const scene::Camera& camera, double across, double upwards);

/// Moves camera and target so that what is at the target's distance follows the hand: parts of the picture's
/// height, x to the right and y upwards.
scene::Camera pan(const scene::Camera& camera, double x, double y);

/// Divides the distance to the target by `factor` (> 0).
scene::Camera dolly(const scene::Camera& camera, double factor);

/// The camera from where it is, moved along its line of sight and turned to the middle of all tori, so that
/// they fill the picture. aspectRatio: width / height.
scene::Camera fit(const scene::Camera& camera, std::span<const scene::TorusInstance> tori,
                  double aspectRatio);

/// Views along the axes, and from a corner.
enum class Preset { Front, Back, Left, Right, Top, Bottom, Corner };
scene::Camera preset(Preset preset, const scene::Camera& camera, std::span<const scene::TorusInstance> tori,
                     double aspectRatio);

}  // namespace raytorus::viewer
