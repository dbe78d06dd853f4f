// SPDX-License-Identifier: MIT
// The body of closed_form_cxx.hpp for one number type, RAYTORUS_VALUE, of which NumberTraits are known:
// included once by the file of that type, because the library's text has include guards.
#include "closed_form_cxx.hpp"
#include "torus/glsl_number.hpp"

namespace raytorus::test {
namespace {
namespace glsl {

using Float = Number<RAYTORUS_VALUE>;
using vec2 = Vector2<Float>;
using vec3 = Vector3<Float>;
using uint = std::uint32_t;

[[maybe_unused]] inline uint max(uint a, uint b) {
    return a < b ? b : a;
}
[[maybe_unused]] inline uint min(uint a, uint b) {
    return b < a ? b : a;
}
[[maybe_unused]] inline Float uintBitsToFloat(uint bits) {
    return Float(static_cast<double>(std::bit_cast<float>(bits)));
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define TORUS_PRECISE
#define TORUS_NO_FMA
#define float Float
#include "torus_cxx/closed_form.glsl"
#undef float
#pragma GCC diagnostic pop

using Value = RAYTORUS_VALUE;

vec3 vector(const Triple<Value>& v) {
    return {Float::of(v[0]), Float::of(v[1]), Float::of(v[2])};
}

Triple<Value> triple(const vec3& v) {
    return {v.x.value, v.y.value, v.z.value};
}

Torus torus(Value majorRadius, Value minorRadius) {
    return {Float::of(majorRadius), Float::of(minorRadius)};
}

TorusReducedRay ray(const ReducedRay<Value>& r) {
    return {vector(r.origin), vector(r.direction), Float::of(r.tubeRadius), Float::of(r.shift),
            Float::of(r.scale)};
}

TorusReducedQuartic quartic(const ReducedQuartic<Value>& q) {
    return {Float::of(q.alpha), Float::of(q.cz), Float::of(q.beta)};
}

ReducedQuartic<Value> plain(const TorusReducedQuartic& q) {
    return {q.alpha.value, q.cz.value, q.beta.value};
}

QuarticRoots<Value> plain(int count, const Float (&roots)[4]) {
    return {count, {roots[0].value, roots[1].value, roots[2].value, roots[3].value}};
}

}  // namespace glsl
}  // namespace

template <class Value>
std::array<Value, 5> ClosedFormCxx<Value>::quarticCoefficients(Value majorRadius, Value minorRadius,
                                                               const Triple<Value>& origin,
                                                               const Triple<Value>& direction) {
    glsl::Float c[5];
    glsl::torusQuarticCoefficients(glsl::torus(majorRadius, minorRadius), glsl::vector(origin),
                                   glsl::vector(direction), c);
    return {c[0].value, c[1].value, c[2].value, c[3].value, c[4].value};
}

template <class Value>
bool ClosedFormCxx<Value>::reduceRay(Value majorRadius, Value minorRadius, const Triple<Value>& origin,
                                     const Triple<Value>& direction, Ray& reduced) {
    glsl::TorusReducedRay r;
    const bool meets = glsl::torusReduceRay(glsl::torus(majorRadius, minorRadius), glsl::vector(origin),
                                            glsl::vector(direction), r);
    reduced = {glsl::triple(r.origin), glsl::triple(r.direction), r.tubeRadius.value, r.shift.value,
               r.scale.value};
    return meets;
}

template <class Value>
Value ClosedFormCxx<Value>::betaSum(const Ray& ray) {
    return glsl::torusBetaSum(glsl::ray(ray)).value;
}

template <class Value>
Value ClosedFormCxx<Value>::betaProduct(const Ray& ray) {
    return glsl::torusBetaProduct(glsl::ray(ray)).value;
}

template <class Value>
ReducedQuartic<Value> ClosedFormCxx<Value>::axialQuartic(const Ray& ray) {
    return glsl::plain(glsl::torusAxialQuartic(glsl::ray(ray)));
}

template <class Value>
ReducedQuartic<Value> ClosedFormCxx<Value>::radialQuartic(const Ray& ray) {
    return glsl::plain(glsl::torusRadialQuartic(glsl::ray(ray)));
}

template <class Value>
QuarticRoots<Value> ClosedFormCxx<Value>::reducedRoots(const Quartic& quartic) {
    glsl::Float roots[4];
    const int count = glsl::torusReducedRoots(glsl::quartic(quartic), roots);
    return glsl::plain(count, roots);
}

template <class Value>
QuarticRoots<Value> ClosedFormCxx<Value>::reducedRootsUnhalved(const Quartic& quartic) {
    glsl::Float roots[4];
    const int count = glsl::torusReducedRootsUnhalved(glsl::quartic(quartic), roots);
    return glsl::plain(count, roots);
}

template <class Value>
QuarticRoots<Value> ClosedFormCxx<Value>::closedFormRoots(Value majorRadius, Value minorRadius,
                                                          const Triple<Value>& origin,
                                                          const Triple<Value>& direction) {
    glsl::Float t[4];
    const int count = glsl::torusClosedFormRoots(glsl::torus(majorRadius, minorRadius), glsl::vector(origin),
                                                 glsl::vector(direction), t);
    return glsl::plain(count, t);
}

template struct ClosedFormCxx<RAYTORUS_VALUE>;

}  // namespace raytorus::test
