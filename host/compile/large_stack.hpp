// SPDX-License-Identifier: MIT
// glslang calls itself once for each operand of a long expression: 200 kB of sums overflow the usual stack of
// 8 MiB, and an overflow cannot be caught.
#pragma once

#include <functional>

namespace raytorus::compile {

/// Runs it in a thread with a stack of 1 GiB, of which only what is used takes memory, and waits for its end.
/// It must not throw. Where the system refuses such a thread, runs it in the calling one.
void runWithLargeStack(const std::function<void()>& work);

}  // namespace raytorus::compile
