// SPDX-License-Identifier: MIT
#include "bench/timed_method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "methods/methods.hpp"
#include "raytorus_bench_baselines.hpp"
#include "raytorus_bench_fast.hpp"
#include "raytorus_bench_fused.hpp"
#include "raytorus_bench_methods.hpp"
#include "raytorus_bench_raytorus.hpp"

namespace raytorus::bench {
namespace {

using trace::ShaderSource;

TimedMethod timed(const EmbeddedMethod& file) {
    return {file.name, file.description, ShaderSource(file.find),
            file.needsFloat64 ? Needs::Float64 : Needs::Nothing};
}

// The library by another compilation of it.
TimedMethod timed(const char* name, ShaderSource::Find find) {
    return {name, raytorus::findMethod(name)->description, ShaderSource(find)};
}

std::vector<TimedMethod> makeTable() {
    std::vector<TimedMethod> table = {
        timed(ourName, bench_raytorus::find),
        timed("raytorus-fast", bench_fast::find),
        {"raytorus-fused", "the library with TORUS_FUSED_FMA, where fma() rounds once",
         ShaderSource(bench_fused::find), Needs::FusedFma},
    };
    for (const EmbeddedMethod& file : raytorus_bench_methods::all) {
        table.push_back(timed(file));
    }
    for (const EmbeddedMethod& file : raytorus_bench_baselines::all) {
        const bool first = file.name == std::string_view(emptyName);
        table.insert(first ? table.begin() : table.end(), timed(file));
    }
    return table;
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
