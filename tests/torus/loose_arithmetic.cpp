// SPDX-License-Identifier: MIT
// A float that rounds as it likes, and what the library's GLSL needs around it to be C++.
#include "loose_arithmetic.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace loose {

raytorus::test::Arithmetic arithmetic;

// What a device does to one pair of numbers it always does: the chance is in the operands (and the seed).
// SplitMix64's mixing: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
std::uint32_t chance(float a, float b, std::uint64_t operation) {
    std::uint64_t z =
        (std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32U | std::bit_cast<std::uint32_t>(b)) ^
        (arithmetic.seed * 4U + operation) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<std::uint32_t>((z ^ (z >> 31U)) >> 32U);
}

// `exact` rounded down or up, by chance; exact results stay.
float rounded(double exact, std::uint32_t drawn) {
    const float nearest = static_cast<float>(exact);
    if (!arithmetic.anyRounding || static_cast<double>(nearest) == exact || (drawn & 1U) == 0) {
        return nearest;
    }
    const float towards = static_cast<double>(nearest) < exact ? std::numeric_limits<float>::infinity()
                                                               : -std::numeric_limits<float>::infinity();
    return std::nextafter(nearest, towards);
}

// `nearest` moved by up to `ulps` places.
float moved(float nearest, int ulps, std::uint32_t drawn) {
    if (ulps == 0 || nearest == 0.0F || !std::isfinite(nearest)) {
        return nearest;
    }
    int steps = static_cast<int>(drawn % static_cast<unsigned>(2 * ulps + 1)) - ulps;
    const float towards =
        steps > 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
    for (steps = std::abs(steps); steps > 0; --steps) {
        nearest = std::nextafter(nearest, towards);
    }
    return nearest;
}

struct Float {
    float value;

    Float() = default;
    Float(float x) : value(x) {}
};

// Products of floats are exact in double; sums are, but for parts too small to matter to which side they are
// on.
inline Float operator+(Float a, Float b) {
    return rounded(static_cast<double>(a.value) + static_cast<double>(b.value), chance(a.value, b.value, 0));
}
inline Float operator-(Float a, Float b) {
    return rounded(static_cast<double>(a.value) - static_cast<double>(b.value), chance(a.value, -b.value, 0));
}
inline Float operator*(Float a, Float b) {
    return rounded(static_cast<double>(a.value) * static_cast<double>(b.value), chance(a.value, b.value, 1));
}
inline Float operator/(Float a, Float b) {
    return moved(a.value / b.value, arithmetic.divisionUlps, chance(a.value, b.value, 2));
}
inline Float operator-(Float a) {
    return -a.value;
}
inline bool operator<(Float a, Float b) {
    return a.value < b.value;
}
inline bool operator>(Float a, Float b) {
    return a.value > b.value;
}
inline bool operator<=(Float a, Float b) {
    return a.value <= b.value;
}
inline bool operator>=(Float a, Float b) {
    return a.value >= b.value;
}
inline bool operator==(Float a, Float b) {
    return a.value == b.value;
}
inline bool operator!=(Float a, Float b) {
    return a.value != b.value;
}

inline Float sqrt(Float x) {
    return moved(std::sqrt(x.value), arithmetic.squareRootUlps, chance(x.value, x.value, 3));
}
inline Float abs(Float x) {
    return std::abs(x.value);
}
inline Float floor(Float x) {
    return std::floor(x.value);
}
inline Float max(Float a, Float b) {
    return a.value < b.value ? b : a;
}
inline Float min(Float a, Float b) {
    return b.value < a.value ? b : a;
}
inline Float clamp(Float x, Float low, Float high) {
    return min(max(x, low), high);
}
using uint = std::uint32_t;
inline uint max(uint a, uint b) {
    return a < b ? b : a;
}
inline uint min(uint a, uint b) {
    return b < a ? b : a;
}
inline uint floatBitsToUint(Float x) {
    return std::bit_cast<uint>(x.value);
}
inline Float uintBitsToFloat(uint bits) {
    return std::bit_cast<float>(bits);
}

struct vec2 {
    Float x, y;
};
struct vec3 {
    Float x, y, z;
};
inline vec3 operator+(const vec3& a, const vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec3 operator-(const vec3& a, const vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec3 operator*(const vec3& a, const vec3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline vec3 operator+(const vec3& a, Float s) {
    return {a.x + s, a.y + s, a.z + s};
}
inline vec3 operator-(const vec3& a, Float s) {
    return {a.x - s, a.y - s, a.z - s};
}
inline vec3 operator*(const vec3& a, Float s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline vec3 operator*(Float s, const vec3& a) {
    return {s * a.x, s * a.y, s * a.z};
}

#define TORUS_PRECISE
#define TORUS_NO_FMA
#define float Float
#include "torus_cxx/torus.glsl"
#undef float

}  // namespace loose

namespace raytorus::test {
namespace {

loose::vec3 vec3(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

void store(float (&to)[3], const loose::vec3& v) {
    to[0] = v.x.value;
    to[1] = v.y.value;
    to[2] = v.z.value;
}

}  // namespace

void setArithmetic(const Arithmetic& arithmetic) {
    loose::arithmetic = arithmetic;
}

trace::NearestHit looseNearest(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    const loose::Torus torus{majorRadius, minorRadius};
    loose::TorusHit hit{};
    const bool found =
        loose::torusIntersect(torus, vec3(ray.origin), ray.tMin, vec3(ray.direction), ray.tMax, hit);
    trace::NearestHit answer{found ? 1.0F : 0.0F, hit.t.value, {}, {}};
    store(answer.position, hit.position);
    if (found) {
        store(answer.normal, loose::torusNormal(torus, hit.position));
    }
    return answer;
}

trace::AllHits looseAll(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    loose::TorusHit hits[4] = {};
    trace::AllHits answer{};
    answer.count = static_cast<float>(loose::torusIntersectAll(
        {majorRadius, minorRadius}, vec3(ray.origin), ray.tMin, vec3(ray.direction), ray.tMax, hits));
    for (int i = 0; i < 4; ++i) {
        answer.t[i] = hits[i].t.value;
        store(answer.position[i], hits[i].position);
    }
    return answer;
}

float looseAny(float majorRadius, float minorRadius, const trace::TraceRay& ray) {
    return loose::torusOccluded({majorRadius, minorRadius}, vec3(ray.origin), ray.tMin, vec3(ray.direction),
                                ray.tMax)
               ? 1.0F
               : 0.0F;
}

}  // namespace raytorus::test
