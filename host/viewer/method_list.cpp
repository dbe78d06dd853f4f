// SPDX-License-Identifier: MIT
#include "viewer/method_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "methods/methods.hpp"
#include "raytorus_steps_bracketed_newton.hpp"
#include "raytorus_steps_raytorus.hpp"
#include "raytorus_steps_sphere_tracing.hpp"

namespace raytorus::viewer {
namespace {

struct StepShaders {
    std::string_view method;
    trace::ShaderSource::Find find;
};

constexpr std::array<StepShaders, 3> stepShaders = {{
    {"raytorus", steps_raytorus::find},
    {"bracketed-newton", steps_bracketed_newton::find},
    {"sphere-tracing", steps_sphere_tracing::find},
}};

}  // namespace

std::vector<MethodEntry> methodList(bool withEdited) {
    std::vector<MethodEntry> list;
    for (const Method& method : methods()) {
        const auto found = std::ranges::find(stepShaders, method.name, &StepShaders::method);
        const trace::ShaderSource steps =
            found != stepShaders.end() ? trace::ShaderSource(found->find) : method.shaders;
        list.push_back({method.name, method.description, method.shaders, steps});
    }
    if (withEdited) {
        list.push_back({"edited", "the shaders in the folder that is being edited", list.front().shaders,
                        list.front().steps, true});
    }
    return list;
}

void replaceShaders(MethodEntry& entry, const trace::ShaderSource& shaders,
                    const trace::ShaderSource& steps) {
    entry.shaders = shaders;
    entry.steps = steps;
    ++entry.version;
}

std::size_t indexOf(const std::vector<MethodEntry>& methods, const std::string& name) {
    const auto found = std::ranges::find(methods, name, &MethodEntry::name);
    if (found == methods.end()) {
        std::string names;
        for (const MethodEntry& method : methods) {
            names += (names.empty() ? "" : " ") + method.name;
        }
        throw Error(ExitCode::Usage, fmt::format("there is no method \"{}\"; there are: {}", name, names));
    }
    return static_cast<std::size_t>(found - methods.begin());
}

}  // namespace raytorus::viewer
