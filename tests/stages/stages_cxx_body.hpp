// SPDX-License-Identifier: MIT
// The body of stages_cxx_exact.cpp and stages_cxx_fast.cpp: the library and its stages, called one by one, in
// the namespace RAYTORUS_STAGES. Compile with -fsingle-precision-constant and no contraction.
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "stages_cxx.hpp"

namespace raytorus::test::RAYTORUS_STAGES {

namespace shader {
using namespace glm;
// GLM's takes -0 to -0.
inline float abs(float x) {
    return std::fabs(x);
}
#include "torus_cxx/torus.glsl"
}  // namespace shader

inline FloatVec3 array(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

inline glm::vec3 vec3(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

class Staged : public StagedRay {
public:
    Staged(const reference::Torus& torus, const reference::Ray& ray)
        : reduced(shader::torus_reduce(torus.majorRadius, torus.minorRadius, vec3(ray.origin), ray.tMin,
                                       vec3(ray.direction), ray.tMax)) {}

    [[nodiscard]] LineStage line() const override {
        return {.meets = reduced.meets,
                .majorRadius = reduced.majorRadius,
                .minorRadius = reduced.minorRadius,
                .base = array(reduced.base),
                .baseLow = array(reduced.baseLow),
                .baseShift = reduced.baseShift,
                .shift = reduced.shift,
                .direction = array(reduced.direction),
                .foot = array(reduced.foot),
                .length2 = reduced.length2,
                .farthest = reduced.farthest,
                .lower = reduced.lower,
                .upper = reduced.upper,
                .fromStart = reduced.fromStart,
                .tPerU = reduced.tPerU,
                .uPerT = reduced.uPerT,
                .unit = reduced.unit};
    }
    bool clip(float tMin, float tMax) override { return shader::torus_clip(reduced, tMin, tMax); }
    void startMarch() override {
        quartic = shader::torus_quartic(reduced);
        at = shader::torus_startMarch(reduced, quartic);
    }
    void place(float u, float side, float reach, bool due) override {
        at.u = u;
        at.side = side;
        at.reach = reach;
        at.searching = true;
        at.refines = due;
        at.certain = false;
        at.known = false;
    }
    [[nodiscard]] MarchStage march() const override {
        return {at.u, at.side, at.reach, at.searching, at.refines, at.certain, at.known, at.f, at.h};
    }
    [[nodiscard]] ParabolaStage parabola() const override {
        const shader::torus_Parabola parabola = shader::torus_parabola(quartic, at);
        return {parabola.g, parabola.s, parabola.C};
    }
    [[nodiscard]] float blur() const override { return quartic.blur; }
    void search(int steps) override { shader::torus_search(quartic, reduced.upper, steps, at); }
    CrossingStage refine() override {
        constexpr float largest = std::numeric_limits<float>::max();
        const shader::torus_Crossing crossing = shader::torus_refine(reduced, at);
        const shader::TorusHit hit = shader::torus_hitAt(reduced, crossing, -largest, largest);
        return {crossing.found, hit.t, array(hit.position)};
    }
    [[nodiscard]] PointStage pointAt([[maybe_unused]] float u) const override {
#ifndef TORUS_FAST
        const shader::torus_Point point = shader::torus_pointAt(reduced, u);
        return {array(point.high), array(point.low), point.shift, point.shiftLow, point.tube};
#else
        return {};
#endif
    }

private:
    shader::torus_Line reduced;
    shader::torus_Quartic quartic{};
    shader::torus_March at{};
};

inline std::unique_ptr<StagedRay> reduce(const reference::Torus& torus, const reference::Ray& ray) {
    return std::make_unique<Staged>(torus, ray);
}

inline shader::TorusHit unwritten() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, glm::vec3(nan)};
}

inline trace::NearestHit nearest(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    const shader::Torus torus{majorRadius, minorRadius};
    shader::TorusHit hit = unwritten();
    const bool found =
        shader::torusIntersect(torus, vec3(ray.origin), ray.tMin, vec3(ray.direction), ray.tMax, hit);
    const glm::vec3 normal = found ? shader::torusNormal(torus, hit.position) : glm::vec3(0.0F);
    return {found ? 1.0F : 0.0F,
            hit.t,
            {hit.position.x, hit.position.y, hit.position.z},
            {normal.x, normal.y, normal.z}};
}

inline trace::AllHits all(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    shader::TorusHit hits[4] = {unwritten(), unwritten(), unwritten(), unwritten()};
    trace::AllHits answer{};
    answer.count = static_cast<float>(shader::torusIntersectAll(
        {majorRadius, minorRadius}, vec3(ray.origin), ray.tMin, vec3(ray.direction), ray.tMax, hits));
    for (int i = 0; i < 4; ++i) {
        answer.t[i] = hits[i].t;
        for (int k = 0; k < 3; ++k) {
            answer.position[i][k] = hits[i].position[k];
        }
    }
    return answer;
}

inline bool any(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    return shader::torusOccluded({majorRadius, minorRadius}, vec3(ray.origin), ray.tMin, vec3(ray.direction),
                                 ray.tMax);
}

}  // namespace raytorus::test::RAYTORUS_STAGES
