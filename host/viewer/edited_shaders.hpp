// SPDX-License-Identifier: MIT
// A folder of GLSL that is being edited: compiled by this program at once and again after each change, beside
// the window's loop, which never waits for it.
#pragma once

#include <filesystem>
#include <future>
#include <string>

#include "compile/file_watch.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::viewer {

class EditedShaders {
public:
    /// The folder has the files of the project's folder `shaders`. Whatever is wrong with it is an error like
    /// any other.
    explicit EditedShaders(std::filesystem::path shaderFolder);
    EditedShaders(const EditedShaders&) = delete;
    EditedShaders& operator=(const EditedShaders&) = delete;

    /// Looks for changes and for what came of the last one. True: error() or the shaders are new.
    bool poll();

    /// Compiles again though nothing has changed.
    void again();

    /// "torus/refine.glsl:12: ...", a line for each error; empty: all compile.
    [[nodiscard]] const std::string& error() const { return result.error; }

    /// The last that compiled: the scene's shaders, and the same with steps counted. False: none has yet.
    [[nodiscard]] bool any() const { return version > 0; }
    [[nodiscard]] const trace::ShaderSource& shaders() const { return good.shaders; }
    [[nodiscard]] const trace::ShaderSource& steps() const { return good.steps; }

private:
    struct Sources {
        trace::ShaderSource shaders;
        trace::ShaderSource steps;
    };
    struct Result {
        Sources sources;
        std::string error;
        std::vector<compile::FileState> files;
    };

    static Result compileAll(const std::filesystem::path& folder);

    std::filesystem::path folder;
    compile::FileWatch watch;
    std::future<Result> work;
    Result result;
    Sources good;
    int version = 0;
};

}  // namespace raytorus::viewer
