// SPDX-License-Identifier: MIT
// The files that the window follows: the scene's own, and the shaders that are edited.
#pragma once

#include <memory>
#include <string>

#include "compile/file_watch.hpp"
#include "viewer/edited_shaders.hpp"
#include "viewer/state.hpp"

namespace raytorus::viewer {

class FollowedFiles {
public:
    /// editFolder: of GLSL; empty: none is edited.
    FollowedFiles(const std::string& sceneFile, const std::string& editFolder);

    /// Reads a scene into the state, and follows its file from now on, though it be broken.
    void open(const std::string& file, State& state);

    /// Whether the scene's file has changed since the last call.
    [[nodiscard]] bool sceneChanged() { return !sceneWatch.poll().empty(); }

    /// Takes what came of the edited shaders: into the state's last method, or into its shaderError. False:
    /// nothing new.
    bool takeShaders(State& state);

    void compileAgain();

    /// What keeps the edited shaders from compiling, or nothing.
    [[nodiscard]] std::string shaderError() const { return edited ? edited->error() : ""; }

    /// Edited shaders are to be seen, and none have been compiled yet.
    [[nodiscard]] bool awaitsShaders() const { return edited && !edited->any(); }

private:
    compile::FileWatch sceneWatch;
    std::unique_ptr<EditedShaders> edited;
};

}  // namespace raytorus::viewer
