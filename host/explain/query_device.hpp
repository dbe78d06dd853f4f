// SPDX-License-Identifier: MIT
// What the shaders make of a ray, by explain.comp.
#pragma once

#include "explain/explanation.hpp"
#include "gpu/context.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::explain {

/// Fills in `shader`, `nearest`, `occluded`, `hits` and `closedForm` for the torus and ray of the
/// explanation.
void queryDevice(gpu::Context& context, const trace::ShaderSource& shaders, Explanation& explanation);

}  // namespace raytorus::explain
