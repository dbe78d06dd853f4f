// SPDX-License-Identifier: MIT
// Ways to intersect a torus, as modules for the place of trace.comp: the library's own, and others to judge
// and time beside it. Each other one is a .glsl file in this folder, which says where its mathematics is
// published.
//
//     render::Tracer tracer(context, query, capacity, render::ShaderSource("trace.comp", method.module));
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace raytorus {

struct Method {
    const char* name;
    const char* description;
    std::span<const std::uint32_t> module;  ///< SPIR-V with the interface of trace.comp; lives for ever
    /// How far t and position may be off on ordinary rays from a few R away, in R + r, and as much in lengths
    /// of the direction. Farther away, nearer to a tangent and in thin tubes some methods have no bound.
    double tolerance;
};

/// The library's own method, "raytorus", is the first.
std::span<const Method> methods();

/// The method with this name, or null.
const Method* findMethod(std::string_view name);

}  // namespace raytorus
