// SPDX-License-Identifier: MIT
// A pixel of the window taken apart.
#pragma once

#include "gpu/context.hpp"
#include "trace/shader_source.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

/// scene: as it is shown. extent: of the picture that x and y count in. deviceWords: what the command has of
/// the device.
Pick pickPixel(gpu::Context& context, const scene::Scene& scene, VkExtent2D extent, int x, int y,
               const trace::ShaderSource& shaders, const std::string& deviceWords);

}  // namespace raytorus::viewer
