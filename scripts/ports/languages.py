# SPDX-License-Identifier: MIT
"""The languages that c_like.py writes."""
from __future__ import annotations

from .c_like import Language

MADE = "// Made of the folder shaders/torus by scripts/dist: "
BITS = {"floatBitsToUint": "asuint", "uintBitsToFloat": "asfloat"}
FLOATS = {"vec2": "float2", "vec3": "float3", "vec4": "float4"}
# Where a language has no `precise`, or its compilers do not heed it.
TIERS = """// A sum or product that is rounded as it stands: the exclusive or with a zero that no compiler can know keeps it from
// being joined with another. The fast tier needs that in one place alone.
#ifdef TORUS_FAST
#define TORUS_R(x) (x)
#else
#define TORUS_R(x) TORUS_SEALED(x)
#endif

"""

HLSL = Language(
    name="HLSL",
    note=MADE + """to include in HLSL (shader model 5 and 6). Every step is `precise`. Where a
// compiler does not heed that, `#define TORUS_NO_PRECISE` before it: the bits are the same without.
""",
    language="""// fma() is for doubles alone.
#define TORUS_NO_FMA

#ifdef TORUS_NO_PRECISE
#define TORUS_PRECISE
#define TORUS_ROUNDED
#define TORUS_SEALED(x) asfloat(asuint(x) ^ zero)
#else
#define TORUS_ROUNDED precise
#define TORUS_SEALED(x) (x)
#ifdef TORUS_FAST
#define TORUS_PRECISE
#else
#define TORUS_PRECISE precise
#endif
#endif
""" + TIERS,
    types=FLOATS, functions=BITS, renamed={"line": "path", "point": "place"})

METAL = Language(
    name="Metal",
    note=MADE + """to include in the Metal shading language, after <metal_stdlib> and
// `using namespace metal`. The bits are the same with fast math.
""",
    language="#define TORUS_SEALED(x) torus_sealed(x, zero)\n" + TIERS,
    types=FLOATS, functions={"floatBitsToUint": "as_type<uint>", "uintBitsToFloat": "as_type<float>"},
    suffix="f", function_prefix="inline ", reference="thread {type}& {name}",
    array_reference="thread {type} (&{name})[{size}]", braces=True,
    prologue="""
inline float torus_sealed(float x, uint zero) {
    return as_type<float>(as_type<uint>(x) ^ zero);
}

inline float3 torus_sealed(float3 x, uint zero) {
    return as_type<float3>(as_type<uint3>(x) ^ uint3(zero));
}
""")

GODOT = Language(
    name="Godot",
    note=MADE + """to include in a shader of Godot 4. Its language has no `precise`; the bits
// are the same without.
""",
    language="#define TORUS_NO_FMA\n#define TORUS_SEALED(x) uintBitsToFloat(floatBitsToUint(x) ^ zero)\n" + TIERS,
    functions={}, renamed={"varying": "varied"})

CXX = Language(
    name="C++",
    note=MADE + """to include in C++ from C++11: the same answers on the CPU, bit by bit, also with
// -ffast-math, but for the normals there, and for rays that are none. Needs nothing else.
""",
    language="#define TORUS_SEALED(x) torus_sealed(x, zero)\n" + TIERS.replace(" (x)\n", " torus_rounded(x, zero)\n"),
    types={"uint": "std::uint32_t"}, suffix="F", function_prefix="inline ", reference="{type}& {name}",
    array_reference="{type} (&{name})[{size}]", braces=True,
    prologue="""
#include <cmath>
#include <cstdint>
#include <cstring>

namespace raytorus_cxx {

struct vec2 {
    float x, y;
    vec2() = default;
    vec2(float firstX, float firstY) : x(firstX), y(firstY) {}
};

struct vec3 {
    float x, y, z;
    vec3() = default;
    vec3(float firstX, float firstY, float firstZ) : x(firstX), y(firstY), z(firstZ) {}
};

inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline vec3 operator*(vec3 a, float b) { return vec3(a.x * b, a.y * b, a.z * b); }
inline vec3 operator*(float a, vec3 b) { return vec3(a * b.x, a * b.y, a * b.z); }
inline float abs(float x) { return std::fabs(x); }
inline float floor(float x) { return std::floor(x); }
inline float sqrt(float x) { return std::sqrt(x); }
inline float fma(float a, float b, float c) { return std::fma(a, b, c); }
inline float max(float a, float b) { return a < b ? b : a; }
inline float min(float a, float b) { return b < a ? b : a; }
inline std::uint32_t max(std::uint32_t a, std::uint32_t b) { return a < b ? b : a; }
inline float clamp(float x, float low, float high) { return min(max(x, low), high); }

inline std::uint32_t floatBitsToUint(float x) {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

inline float uintBitsToFloat(std::uint32_t bits) {
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

inline float torus_sealed(float x, std::uint32_t zero) { return uintBitsToFloat(floatBitsToUint(x) ^ zero); }

template <typename T>
T torus_rounded(T x, std::uint32_t) {
    return x;
}

inline vec3 torus_sealed(vec3 v, std::uint32_t zero) {
    return vec3(torus_sealed(v.x, zero), torus_sealed(v.y, zero), torus_sealed(v.z, zero));
}
""",
    epilogue="}  // namespace raytorus_cxx\n\n")
