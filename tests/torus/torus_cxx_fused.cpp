// SPDX-License-Identifier: MIT
// The library's GLSL as C++ once more, as a device has it whose fma() rounds once.
#include <cmath>
#include <glm/glm.hpp>

#include "torus_cxx.hpp"
#include "torus_cxx_all.hpp"

namespace torus_cxx_fused {
using namespace glm;
inline float abs(float x) {
    return std::fabs(x);
}
inline float fma(float a, float b, float c) {
    return std::fma(a, b, c);
}
#define TORUS_PRECISE
#define TORUS_FUSED_FMA
#include "torus_cxx/torus.glsl"
}  // namespace torus_cxx_fused

namespace raytorus::test {

trace::AllHits cxxAllFused(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    return allHits(torus_cxx_fused::torusIntersectAll, torus_cxx_fused::Torus{majorRadius, minorRadius}, ray);
}

float cxxProductErrorFused(float a, float b) {
    return torus_cxx_fused::torus_twoProductError(a, b, a * b);
}

}  // namespace raytorus::test
