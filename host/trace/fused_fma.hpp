// SPDX-License-Identifier: MIT
// Whether a device's fma() rounds once, which Vulkan does not say: then a shader may define TORUS_FUSED_FMA.
#pragma once

#include "gpu/context.hpp"

namespace raytorus::trace {

/// Asks the device, by one invocation of fused_fma.comp.
bool fusesFma(gpu::Context& context);

}  // namespace raytorus::trace
