// SPDX-License-Identifier: MIT
// The library's own GLSL, compiled as C++ with GLM: the twin of trace.comp and probe.comp on the CPU.
#pragma once

#include "support/surface_probe.hpp"
#include "trace/tracer.hpp"

namespace raytorus::test {

trace::NearestHit cxxNearest(float majorRadius, float minorRadius, const trace::TraceRay& ray);
trace::AllHits cxxAll(float majorRadius, float minorRadius, const trace::TraceRay& ray);
float cxxAny(float majorRadius, float minorRadius, const trace::TraceRay& ray);
SurfaceAnswer cxxSurface(const SurfacePoint& point);
/// The same, compiled with TORUS_FUSED_FMA and an fma() that rounds once.
trace::AllHits cxxAllFused(float majorRadius, float minorRadius, const trace::TraceRay& ray);
float cxxProductError(float a, float b);  ///< what rounding takes from a * b
float cxxProductErrorFused(float a, float b);
float cxxSquareDifference(float a, float b, float c);  ///< a^2 + b^2 - c^2 as the library's last step has it

}  // namespace raytorus::test
