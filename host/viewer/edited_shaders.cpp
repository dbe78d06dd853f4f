// SPDX-License-Identifier: MIT
#include "viewer/edited_shaders.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <utility>

#include "compile/compile_shader.hpp"

namespace raytorus::viewer {
namespace {

constexpr std::size_t mostErrors = 8;  // shown: the first is the one to mend

}  // namespace

EditedShaders::EditedShaders(std::filesystem::path shaderFolder) : folder(std::move(shaderFolder)) {
    again();
}

void EditedShaders::again() {
    if (!work.valid()) {
        work = std::async(std::launch::async, [path = folder] { return compileAll(path); });
    }
}

EditedShaders::Result EditedShaders::compileAll(const std::filesystem::path& folder) {
    Result result;
    auto plain = std::make_shared<trace::ShaderSource::Modules>();
    auto counting = std::make_shared<trace::ShaderSource::Modules>();
    std::vector<std::string> errors;
    const auto compileOne = [&](const char* name, bool steps) {
        compile::ShaderRequest request;
        request.entry = folder / name;
        request.roots = {folder};
        if (steps) {
            request.defines.push_back({"COUNT_STEPS", ""});
        }
        compile::CompiledShader shader = compile::compileShader(request);
        for (const compile::CompileError& error : shader.errors) {
            const std::string text = compile::describe(error);
            // What is wrong in an include is wrong in every shader that has it.
            if (std::ranges::find(errors, text) == errors.end()) {
                errors.push_back(text);
            }
        }
        result.files.insert(result.files.end(), shader.files.begin(), shader.files.end());
        (steps ? counting : plain)->insert_or_assign(name, std::move(shader.words));
        return !shader.ended;
    };
    for (const char* name : {"scene.frag", "scene.comp", "fullscreen.vert", "explain.comp"}) {
        if (!compileOne(name, false)) {
            break;  // so would the others, each after as long a time
        }
    }
    for (const char* name : {"scene.frag", "scene.comp"}) {
        if (errors.empty()) {
            compileOne(name, true);
        }
    }
    for (std::size_t i = 0; i < std::min(errors.size(), mostErrors); ++i) {
        result.error += (i == 0 ? "" : "\n") + errors[i];
    }
    if (errors.size() > mostErrors) {
        result.error += "\n...";
    }
    result.sources = {trace::ShaderSource(plain), trace::ShaderSource(counting)};
    return result;
}

bool EditedShaders::poll() {
    if (!work.valid()) {
        if (!watch.poll().empty()) {
            again();
        }
        return false;
    }
    if (work.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return false;
    }
    result = work.get();
    watch.watch(std::exchange(result.files, {}));  // what has changed since it was read is told, too
    if (result.error.empty()) {
        good = result.sources;
        ++version;
    }
    return true;
}

}  // namespace raytorus::viewer
