// SPDX-License-Identifier: MIT
// Rays in, exact hits out: what trace::Tracer answers, by the reference, in its layout.
#pragma once

#include <span>
#include <vector>

#include "reference/torus_reference.hpp"
#include "trace/hits.hpp"

namespace raytorus::truth {

/// The 113-bit hits, each rounded once to float32: hitFloats(query) floats a ray. On the CPU, by all its
/// processors; some hundred times slower than a shader.
std::vector<float> traceByReference(trace::Query query, const reference::Torus& torus,
                                    std::span<const trace::TraceRay> rays);

}  // namespace raytorus::truth
