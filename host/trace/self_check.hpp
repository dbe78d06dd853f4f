// SPDX-License-Identifier: MIT
// What a device's arithmetic is like, by the library's own torusSelfCheck.
#pragma once

#include "gpu/context.hpp"

namespace raytorus::trace {

struct SelfCheck {
    bool exact = false;  ///< it holds what the exact tier rests on
    bool fusedFma =
        false;  ///< fma() rounds once, which Vulkan does not say: TORUS_FUSED_FMA gives the same bits
    bool denormals = false;  ///< they are kept
};

/// Asks the device, by one invocation of self_check.comp.
SelfCheck selfCheck(gpu::Context& context);

}  // namespace raytorus::trace
