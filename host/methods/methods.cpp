// SPDX-License-Identifier: MIT
#include "methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "raytorus_method_fast.hpp"
#include "raytorus_method_shaders.hpp"

namespace raytorus {

namespace {

// What the library's last step leaves, with room for the rounding of t.
constexpr double exact = 4e-7;
// What the fast tier promises of a position, the same.
constexpr double fastTier = 1.1e-5;

// The library's two tiers, then the files of this folder.
std::vector<Method> makeTable() {
    std::vector<Method> table = {
        {"raytorus", "the library: a march by certified steps on the reduced quartic, then an exact step",
         trace::ShaderSource(), exact, reference::Tier::Exact},
        {"raytorus-fast", "the library with TORUS_FAST: the same march in plain float32",
         trace::ShaderSource(fast::find), fastTier, reference::Tier::Fast},
    };
    for (const EmbeddedMethod& file : raytorus_method_shaders::all) {
        table.push_back({file.name, file.description, trace::ShaderSource(file.find), file.tolerance});
    }
    return table;
}

}  // namespace

std::span<const Method> methods() {
    static const std::vector<Method> table = makeTable();
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
