// SPDX-License-Identifier: MIT
#pragma once

#include "bench/result.hpp"
#include "gpu/context.hpp"

namespace raytorus::bench {

/// The device, and the computer around it.
Machine describeMachine(const gpu::Context& context);

/// "llvmpipe (LLVM 15.0.6, 256 bits), llvmpipe Mesa 25.0.7 ..., LP_NUM_THREADS=1, ...": one line.
std::string machineText(const Machine& machine);

}  // namespace raytorus::bench
