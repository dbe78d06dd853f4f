// SPDX-License-Identifier: MIT
// How a hand moves a camera. Pure mathematics on render::Camera: no window, no device.
#pragma once

#include <span>
#include <vector>

#include "render/scene.hpp"

namespace raytorus::viewer {

/// Turns the camera round its target: `across` radians round the axis of `up` and `upwards` over it. Never
/// over the poles: it stops short of them.
render::Camera orbit(const render::Camera& camera, double across, double upwards);

/// Moves camera and target so that what is at the target's distance follows the hand: parts of the picture's
/// height, x to the right and y upwards.
render::Camera pan(const render::Camera& camera, double x, double y);

/// Divides the distance to the target by `factor` (> 0).
render::Camera dolly(const render::Camera& camera, double factor);

/// The camera from where it is, moved along its line of sight and turned to the middle of all tori, so that
/// they fill the picture. aspectRatio: width / height.
render::Camera fit(const render::Camera& camera, std::span<const render::TorusInstance> tori,
                   double aspectRatio);

/// Views along the axes, and from a corner.
enum class Preset { Front, Back, Left, Right, Top, Bottom, Corner };
render::Camera preset(Preset preset, const render::Camera& camera,
                      std::span<const render::TorusInstance> tori, double aspectRatio);

}  // namespace raytorus::viewer
