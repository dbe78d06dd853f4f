// SPDX-License-Identifier: MIT
// One ray, answered by the shaders and by the reference.
#pragma once

#include "explain/explanation.hpp"
#include "gpu/context.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::explain {

/// Any ten numbers are explained: bad input, NaN among it, by what the library answers to it.
Explanation explain(gpu::Context& context, const reference::Torus& torus, const reference::Ray& ray,
                    const trace::ShaderSource& shaders = {});

}  // namespace raytorus::explain
