// SPDX-License-Identifier: MIT
#include "bench/methods/methods.hpp"

#include <algorithm>
#include <array>

#include "raytorus_method_shaders.hpp"
#include "raytorus_shaders.hpp"

namespace raytorus {

namespace {

// What the library's last step leaves, with room for the rounding of t.
constexpr double exact = 4e-7;

}  // namespace

std::span<const Method> methods() {
    static const std::array table{
        Method{"raytorus", "the library: Newton on the extrema of the tube function, bracketed roots",
               shaders::find("trace.comp"), exact},
        Method{"newton-quartic", "monotone Newton on the convex and concave pieces of the reduced quartic",
               method_shaders::find("newton_quartic.comp"), exact},
        Method{"minima-first", "signs at the closed-form minima of the reduced quartic, then Newton",
               method_shaders::find("minima_first.comp"), exact},
        Method{"closed-form", "the reduced quartic by its formula", method_shaders::find("closed_form.comp"),
               exact},
        Method{"closed-form-naive", "the quartic of the ray in world space by its formula, in plain float32",
               method_shaders::find("closed_form_naive.comp"), 2e-3},
        Method{"sphere-tracing", "marching along the distance to the surface, to 1e-4 r",
               method_shaders::find("sphere_tracing.comp"), 1e-3},
    };
    return table;
}

const Method* findMethod(std::string_view name) {
    const std::span<const Method> all = methods();
    const auto found =
        std::ranges::find(all, name, [](const Method& row) { return std::string_view(row.name); });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace raytorus
