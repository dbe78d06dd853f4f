// SPDX-License-Identifier: MIT
// Faults with bad or extreme input, and of trace.comp, which pictures do not use. No scene can hold bad
// input: these are for the numeric tests alone.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* ray = "torus/ray.glsl";
constexpr const char* torus = "torus/torus.glsl";
constexpr const char* trace = "trace.comp";

constexpr Mutation rows[] = {
    {"radius-zero-allowed", ray, "minorRadius > 0.0 && majorRadius", "minorRadius >= 0.0 && majorRadius",
     "a tube without thickness can be hit", Shows::InNumbers},
    {"radius-unchecked", ray, "minorRadius > 0.0 && majorRadius", "majorRadius",
     "a negative tube radius can be hit", Shows::InNumbers},
    {"ring-radius-unchecked", ray, "majorRadius >= 0.0 && tMin", "tMin", "a negative ring radius can be hit",
     Shows::InNumbers},
    {"size-unchecked", ray, "size - TORUS_LEAST_SIZE < TORUS_SIZE_RANGE && ", "", "reciprocals overflow",
     Shows::InNumbers},
    {"size-range-wide", ray, "#define TORUS_SIZE_RANGE 0x3c000000u", "#define TORUS_SIZE_RANGE 0x40000000u",
     "the largest size too large", Shows::InNumbers},
    {"size-range-narrow", ray, "#define TORUS_LEAST_SIZE 0x21800000u", "#define TORUS_LEAST_SIZE 0x3f000000u",
     "the least size too large"},
    {"direction-unchecked", ray, " && longest - TORUS_LEAST_LENGTH < TORUS_LENGTH_RANGE", "",
     "a zero direction divides by zero", Shows::InNumbers},
    {"direction-range-wide", ray, "#define TORUS_LENGTH_RANGE 0x3f800000u",
     "#define TORUS_LENGTH_RANGE 0x5f800000u", "the longest direction too long", Shows::InNumbers},
    {"direction-range-narrow", ray, "#define TORUS_LEAST_LENGTH 0x20000000u",
     "#define TORUS_LEAST_LENGTH 0x3e800000u", "the shortest direction too long", Shows::InNumbers},
    {"empty-interval-unchecked", ray, " && tMin <= tMax &&", " &&", "tMin > tMax, or a NaN, finds hits",
     Shows::InNumbers},
    {"validity-dropped", ray, "torus_Line(valid && chord2", "torus_Line(chord2",
     "what was found invalid goes on", Shows::InNumbers},
    {"miss-keeps-a-nan", torus, "tMax >= -TORUS_FLOAT_MAX ? tMax : 0.0", "tMax", "a NaN goes through",
     Shows::InNumbers},
    {"miss-unwritten", torus, "TorusHit nearest = torus_miss(tMax)",
     "TorusHit nearest = TorusHit(-1.0, vec3(0.0))", "a sentinel in place of what is promised of a miss",
     Shows::InNumbers},
    {"misses-past-the-count", torus, "hits[i] = torus_miss(tMax)", "hits[i] = torus_miss(0.0)",
     "entries past the count hold something else", Shows::InNumbers},
    {"strict-ends", ray, "return lower <= upper;", "return lower < upper - 1.0e-3;",
     "short segments are thrown away"},
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
