// SPDX-License-Identifier: MIT
#include "methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "raytorus_method_bracketed_newton.hpp"
#include "raytorus_method_closed_form.hpp"
#include "raytorus_method_closed_form_common.hpp"
#include "raytorus_method_closed_form_naive.hpp"
#include "raytorus_method_closed_form_polished.hpp"
#include "raytorus_method_fast.hpp"
#include "raytorus_method_sphere_tracing.hpp"
#include "raytorus_method_sphere_tracing_exact.hpp"

namespace raytorus {

namespace {

// What the library's last step leaves, with room for the rounding of t.
constexpr double exact = 4e-7;
// What the fast tier promises of a position, the same.
constexpr double fastTier = 1.1e-5;

}  // namespace

std::span<const Method> methods() {
    static const std::array table{
        Method{"raytorus",
               "the library: a march by certified steps on the reduced quartic, then an exact step",
               trace::ShaderSource(), exact, reference::Tier::Exact},
        Method{"raytorus-fast", "the library with TORUS_FAST: the same march in plain float32",
               trace::ShaderSource(fast::find), fastTier, reference::Tier::Fast},
        Method{"bracketed-newton", "bracketed Newton between the critical points of the reduced quartic",
               trace::ShaderSource(bracketed_newton::find), exact},
        Method{"closed-form-polished",
               "the reduced quartic by its formula, mended: polished resolvent, exact last step",
               trace::ShaderSource(closed_form_polished::find), exact},
        Method{"closed-form", "the reduced quartic by its formula, as it stands in the library's derivation",
               trace::ShaderSource(closed_form::find), 2e-3},
        Method{"closed-form-naive", "the quartic of the ray in world space by its formula, in plain float32",
               trace::ShaderSource(closed_form_naive::find), 2e-3},
        Method{"closed-form-common", "the same in world space as it is usually pasted, but tuned",
               trace::ShaderSource(closed_form_common::find), 2e-3},
        Method{"sphere-tracing", "marching along the distance to the surface, to 1e-4 r",
               trace::ShaderSource(sphere_tracing::find), 1e-3},
        Method{"sphere-tracing-exact", "the same on the library's reduced line, with its exact last step",
               trace::ShaderSource(sphere_tracing_exact::find), exact},
    };
    return table;
}

const Method* findMethod(std::string_view name) {
    const std::span<const Method> all = methods();
    const auto found =
        std::ranges::find(all, name, [](const Method& row) { return std::string_view(row.name); });
    return found == all.end() ? nullptr : &*found;
}

std::string methodNames() {
    std::string names;
    for (const Method& method : methods()) {
        names += fmt::format("{}{}", names.empty() ? "" : " ", method.name);
    }
    return names;
}

}  // namespace raytorus
