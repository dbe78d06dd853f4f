// SPDX-License-Identifier: MIT
// All hits by the library's GLSL as C++, of which there are several compilations.
#pragma once

#include <glm/glm.hpp>

#include "trace/tracer.hpp"

namespace raytorus::test {

template <typename Torus, typename Hit>
trace::AllHits allHits(int (*intersectAll)(Torus, glm::vec3, float, glm::vec3, float, Hit (&)[4]),
                       const Torus& torus, const trace::TraceRay& ray) {
    Hit hits[4] = {};
    trace::AllHits answer{};
    answer.count = static_cast<float>(
        intersectAll(torus, {ray.origin[0], ray.origin[1], ray.origin[2]}, ray.tMin,
                     {ray.direction[0], ray.direction[1], ray.direction[2]}, ray.tMax, hits));
    for (int i = 0; i < 4; ++i) {
        answer.t[i] = hits[i].t;
        for (int k = 0; k < 3; ++k) {
            answer.position[i][k] = hits[i].position[k];
        }
    }
    return answer;
}

}  // namespace raytorus::test
