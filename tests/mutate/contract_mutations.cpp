// SPDX-License-Identifier: MIT
// Faults with bad or extreme input, and of trace.comp, which pictures do not use. No scene can hold bad
// input: these are for the numeric tests alone.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* line = "torus/line.glsl";
constexpr const char* torus = "torus/torus.glsl";
constexpr const char* trace = "trace.comp";

constexpr Mutation rows[] = {
    {"radius-zero-allowed", line, "minorRadius > 0.0 && majorRadius", "minorRadius >= 0.0 && majorRadius",
     "a tube without thickness can be hit", Shows::InNumbers},
    {"radius-unchecked", line, "minorRadius > 0.0 && majorRadius", "majorRadius",
     "a negative tube radius can be hit", Shows::InNumbers},
    {"ring-radius-unchecked", line, "majorRadius >= 0.0 && size", "size", "a negative ring radius can be hit",
     Shows::InNumbers},
    {"size-unchecked", line,
     " && size >= TORUS_LEAST_SIZE &&\n                 size < TORUS_LARGEST_SIZE + 0x00800000u", "",
     "reciprocals overflow", Shows::InNumbers},
    {"direction-unchecked", line,
     " && longest >= TORUS_LEAST_LENGTH &&\n                 longest < TORUS_LARGEST_LENGTH + 0x00800000u",
     "", "a zero direction divides by zero", Shows::InNumbers},
    {"empty-interval-unchecked", line, " && tMin <= tMax;", ";", "tMin > tMax, or a NaN, finds hits",
     Shows::InNumbers},
    {"validity-dropped", line, "meets = valid && chord2", "meets = chord2", "what was found invalid goes on",
     Shows::InNumbers},
    {"miss-keeps-a-nan", torus, "tMax >= -TORUS_FLOAT_MAX ? tMax : 0.0", "tMax", "a NaN goes through",
     Shows::InNumbers},
    {"miss-unwritten", torus, "TorusHit nearest = torus_miss(tMax)",
     "TorusHit nearest = TorusHit(-1.0, vec3(0.0))", "a sentinel in place of what is promised of a miss",
     Shows::InNumbers},
    {"misses-past-the-count", torus, "hits[i] = torus_miss(tMax)", "hits[i] = torus_miss(0.0)",
     "entries past the count hold something else", Shows::InNumbers},
    {"strict-ends", line, "return lower <= upper && farthest2", "return lower < upper - 1.0e-3 && farthest2",
     "short segments are thrown away", Shows::InNumbers},
    {"trace-ends-swapped", trace, "float tMin = rays[ray + 3u]", "float tMin = rays[ray + 7u]",
     "tMin read from tMax' place", Shows::InNumbers},
    {"trace-normal-of-a-miss", trace, "found ? torusNormal(torus, hit.position) : vec3(0.0)",
     "torusNormal(torus, hit.position)", "a miss has a normal", Shows::InNumbers},
    {"trace-normal-towards-viewer", trace, "found ? torusNormal(torus, hit.position) : vec3(0.0)",
     "found ? faceforward(torusNormal(torus, hit.position), direction, torusNormal(torus, hit.position)) : "
     "vec3(0.0)",
     "the normal is outward, whoever looks", Shows::InNumbers},
    {"trace-three-hits", trace, "k < 4u", "k < 3u", "the fourth hit is not written", Shows::InNumbers},
};

}  // namespace

std::span<const Mutation> contractMutations() {
    return rows;
}

}  // namespace raytorus::mutate
