// SPDX-License-Identifier: MIT
#include "bench/timed_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "raytorus_bench_bracketed_newton.hpp"
#include "raytorus_bench_closed_form.hpp"
#include "raytorus_bench_closed_form_common.hpp"
#include "raytorus_bench_closed_form_naive.hpp"
#include "raytorus_bench_closed_form_polished.hpp"
#include "raytorus_bench_empty.hpp"
#include "raytorus_bench_exact_ends.hpp"
#include "raytorus_bench_fast.hpp"
#include "raytorus_bench_float64_quartic.hpp"
#include "raytorus_bench_fused.hpp"
#include "raytorus_bench_ray_sphere.hpp"
#include "raytorus_bench_raytorus.hpp"
#include "raytorus_bench_sphere_tracing.hpp"
#include "raytorus_bench_sphere_tracing_exact.hpp"

namespace raytorus::bench {
namespace {

using trace::ShaderSource;

std::vector<TimedMethod> makeTable() {
    return {
        {emptyName, "no intersection: making rays and using answers, taken from all other times",
         ShaderSource(bench_empty::find)},
        {ourName, "the library", ShaderSource(bench_raytorus::find)},
        {"raytorus-fused", "the library with TORUS_FUSED_FMA, where fma() rounds once",
         ShaderSource(bench_fused::find), Needs::FusedFma},
        {"raytorus-fast", "the library with TORUS_FAST, in plain float32", ShaderSource(bench_fast::find)},
        {"closed-form-common", "what everybody pastes: world space, trigonometric resolvent, tuned",
         ShaderSource(bench_closed_form_common::find)},
        {"closed-form-naive", "the same mathematics as it is usually written",
         ShaderSource(bench_closed_form_naive::find)},
        {"closed-form", "the reduced quartic by its formula, as it stands in the derivation",
         ShaderSource(bench_closed_form::find)},
        {"closed-form-polished", "the reduced quartic by its formula, mended, exact last step",
         ShaderSource(bench_closed_form_polished::find)},
        {"sphere-tracing", "marching to 1e-4 r", ShaderSource(bench_sphere_tracing::find)},
        {"sphere-tracing-exact", "the same, with the library's reduction and its exact last step",
         ShaderSource(bench_sphere_tracing_exact::find)},
        {"bracketed-newton", "bracketed Newton between critical points (Yuksel 2022), reduced quartic",
         ShaderSource(bench_bracketed_newton::find)},
        {"float64-quartic", "bracketed Newton on the reduced quartic in float64",
         ShaderSource(bench_float64_quartic::find), Needs::Float64},
        {"exact-ends",
         "the floor of exactness: the library's reduction and last step, with nothing found between",
         ShaderSource(bench_exact_ends::find)},
        {"ray-sphere", "the floor: the bounding sphere, which cannot be right",
         ShaderSource(bench_ray_sphere::find)},
    };
}

std::string names() {
    std::string text;
    for (const TimedMethod& method : timedMethods()) {
        text += (text.empty() ? "" : " ") + method.name;
    }
    return text;
}

}  // namespace

std::span<const TimedMethod> timedMethods() {
    static const std::vector<TimedMethod> table = makeTable();
    return table;
}

std::vector<TimedMethod> chooseMethods(std::span<const std::string> wanted) {
    for (const std::string& name : wanted) {
        if (std::ranges::none_of(timedMethods(), [&](const TimedMethod& row) { return row.name == name; })) {
            throw Error(ExitCode::Usage,
                        fmt::format("--method: there is no method \"{}\" (there are {})", name, names()));
        }
    }
    std::vector<TimedMethod> chosen;
    for (const TimedMethod& row : timedMethods()) {
        const bool always = row.name == emptyName || row.name == ourName;
        if (wanted.empty() || always || std::ranges::find(wanted, row.name) != wanted.end()) {
            chosen.push_back(row);
        }
    }
    return chosen;
}

}  // namespace raytorus::bench
