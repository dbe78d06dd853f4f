// SPDX-License-Identifier: MIT
// The library's GLSL as C++ once more, as a device has it whose fma() rounds once.
#include <cmath>
#include <glm/glm.hpp>

#include "torus_cxx.hpp"

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

render::AllHits cxxAllFused(float majorRadius, float minorRadius, const render::TraceRay& ray) {
    torus_cxx_fused::TorusHit hits[4] = {};
    render::AllHits answer{};
    answer.count = static_cast<float>(torus_cxx_fused::torusIntersectAll(
        {majorRadius, minorRadius}, {ray.origin[0], ray.origin[1], ray.origin[2]}, ray.tMin,
        {ray.direction[0], ray.direction[1], ray.direction[2]}, ray.tMax, hits));
    for (int i = 0; i < 4; ++i) {
        answer.t[i] = hits[i].t;
        for (int k = 0; k < 3; ++k) {
            answer.position[i][k] = hits[i].position[k];
        }
    }
    return answer;
}

float cxxProductErrorFused(float a, float b) {
    return torus_cxx_fused::torus_productError(a, b, a * b);
}

}  // namespace raytorus::test
