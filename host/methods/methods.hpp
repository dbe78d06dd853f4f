// SPDX-License-Identifier: MIT
// Ways to intersect a torus, compiled into trace.comp and the scene's shaders: the library's own, and others
// to judge, to look at and to time beside it. Each other one is a .glsl file in this folder, of which the
// head is its row here (MethodFiles.cmake); what several of them share is in parts/.
//
//     trace::Tracer tracer(context, query, capacity, method.shaders);
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reference/promise.hpp"
#include "trace/shader_source.hpp"

namespace raytorus {

struct Method {
    const char* name;
    const char* description;
    trace::ShaderSource shaders;
    /// How far t and position may be off on ordinary rays from a few R away, in R + r, and as much in lengths
    /// of the direction. Farther away, nearer to a tangent and in thin tubes some methods have no bound.
    double tolerance;
    /// What it promises, if it does: docs/accuracy.md.
    std::optional<reference::Tier> tier = std::nullopt;
};

/// The library is the first, "raytorus", and its fast tier the second; the others follow by name.
std::span<const Method> methods();

/// The method with this name, or null.
const Method* findMethod(std::string_view name);

/// Their names, with spaces between them.
std::string methodNames();

}  // namespace raytorus
