// SPDX-License-Identifier: MIT
// All that the GLSL needs to be C++: GLM's names, `precise` gone (compile without contraction into fma),
// literals that are float (-fsingle-precision-constant), and an abs that is GLSL's: GLM's takes -0 to -0.
#include "torus_cxx.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "torus_cxx_all.hpp"

namespace torus_cxx {
using namespace glm;
inline float abs(float x) {
    return std::fabs(x);
}
#define TORUS_PRECISE
#include "torus_cxx/torus.glsl"
}  // namespace torus_cxx

namespace raytorus::test {
namespace {

glm::vec3 vec3(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

void store(float (&to)[3], const glm::vec3& v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

}  // namespace

trace::NearestHit cxxNearest(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    const torus_cxx::Torus torus{majorRadius, minorRadius};
    torus_cxx::TorusHit hit{};
    const bool found =
        torus_cxx::torusIntersect(torus, vec3(ray.origin), ray.tMin, vec3(ray.direction), ray.tMax, hit);
    trace::NearestHit answer{found ? 1.0F : 0.0F, hit.t, {}, {}};
    store(answer.position, hit.position);
    store(answer.normal, found ? torus_cxx::torusNormal(torus, hit.position) : glm::vec3(0.0F));
    return answer;
}

trace::AllHits cxxAll(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    return allHits(torus_cxx::torusIntersectAll, torus_cxx::Torus{majorRadius, minorRadius}, ray);
}

float cxxAny(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    return torus_cxx::torusOccluded({majorRadius, minorRadius}, vec3(ray.origin), ray.tMin,
                                    vec3(ray.direction), ray.tMax)
               ? 1.0F
               : 0.0F;
}

SurfaceAnswer cxxSurface(const SurfacePoint& point) {
    const torus_cxx::Torus torus{point.majorRadius, point.minorRadius};
    const glm::vec3 at = vec3(point.point);
    SurfaceAnswer answer{};
    store(answer.normal, torus_cxx::torusNormal(torus, at));
    const glm::vec2 uv = torus_cxx::torusUv(torus, at);
    answer.uv[0] = uv.x;
    answer.uv[1] = uv.y;
    store(answer.position, torus_cxx::torusPosition(torus, {point.uv[0], point.uv[1]}));
    glm::vec3 dPdu(0.0F);
    glm::vec3 dPdv(0.0F);
    torus_cxx::torusTangents(torus, at, dPdu, dPdv);
    store(answer.dPdu, dPdu);
    store(answer.dPdv, dPdv);
    answer.distance = torus_cxx::torusDistance(torus, at);
    answer.implicit = torus_cxx::torusImplicit(torus, at);
    return answer;
}

float cxxProductError(float a, float b) {
    return torus_cxx::torus_twoProductError(a, b, a * b);
}

float cxxSquareDifference(float a, float b, float c) {
    return torus_cxx::torus_squareDifference(a, b, c);
}

}  // namespace raytorus::test
