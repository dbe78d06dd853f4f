// SPDX-License-Identifier: MIT
// Who is timed: raytorus::methods, and baselines that answer another query or need more than float32.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "trace/shader_source.hpp"

namespace raytorus::bench {

/// What a device must have for a method; the others leave it out.
enum class Needs { Nothing, Float64, FusedFma };

struct TimedMethod {
    std::string name;
    std::string description;
    trace::ShaderSource shaders;  ///< bench.comp, one_ray.comp and trace.comp
    Needs needs = Needs::Nothing;
};

/// What all others are compared with, and what is taken from all times.
inline constexpr const char* ourName = "raytorus";
inline constexpr const char* emptyName = "empty";

/// The empty one first, then the library, then the others.
std::span<const TimedMethod> timedMethods();

/// Those with these names, in the order of the table, and always the first two. Throws Error{Usage} that
/// lists the names if there is no such method. No names: all.
std::vector<TimedMethod> chooseMethods(std::span<const std::string> names);

}  // namespace raytorus::bench
