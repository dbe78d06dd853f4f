// SPDX-License-Identifier: MIT
// A copy of the shaders with one mutation in it, compiled.
#pragma once

#include <filesystem>
#include <string>

#include "mutate/mutation.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::mutate {

class Mutant {
public:
    /// Copies the shaders to `folder`, changes them (nothing, without a mutation) and compiles them as the
    /// build does. Throws Error{Internal} for a stale row, Error{Shader} for one that does not compile.
    Mutant(const Mutation* mutation, std::filesystem::path folder);

    /// All the host's shaders, and probe.comp.
    [[nodiscard]] const trace::ShaderSource& shaders() const { return source; }
    /// trace.comp with TORUS_FAST.
    [[nodiscard]] const trace::ShaderSource& fastShaders() const { return fast; }

    /// Whether the mutation changed this shader; where it has not, there is nothing to test.
    [[nodiscard]] bool changes(const std::string& shader) const;
    [[nodiscard]] bool changesFast() const;

private:
    trace::ShaderSource source;
    trace::ShaderSource fast;
};

}  // namespace raytorus::mutate
