// SPDX-License-Identifier: MIT
#include "viewer/followed_files.hpp"

#include <filesystem>

#include "scene/scene_json.hpp"

namespace raytorus::viewer {
namespace {

compile::FileWatch watchOf(const std::string& file) {
    compile::FileWatch watch;
    const std::filesystem::path path = std::filesystem::absolute(file);
    watch.watch({{path, compile::fingerprint(compile::readSourceFile(path))}});
    return watch;
}

}  // namespace

FollowedFiles::FollowedFiles(const std::string& sceneFile, const std::string& editFolder)
    : sceneWatch(watchOf(sceneFile)),
      edited(editFolder.empty() ? nullptr : std::make_unique<EditedShaders>(editFolder)) {}

void FollowedFiles::open(const std::string& file, State& state) {
    sceneWatch = watchOf(file);  // first, so that a broken scene is read again when it is mended
    const scene::Scene read = scene::readScene(file);
    // Whoever edits the file keeps the view of it, unless it is the camera that was edited.
    const bool sameCamera = file == state.sceneFile && read.camera == state.fileScene.camera;
    const scene::Camera camera = sameCamera ? state.scene.camera : read.camera;
    state.sceneFile = file;
    state.fileScene = read;
    state.scene = read;
    state.scene.camera = camera;
    state.selectedTorus = 0;
    state.pick.reset();
}

bool FollowedFiles::takeShaders(State& state) {
    if (!edited || !edited->poll()) {
        return false;
    }
    state.shaderError = edited->error();
    if (state.shaderError.empty()) {
        replaceShaders(state.methods.back(), edited->shaders(), edited->steps());
    }
    return true;
}

void FollowedFiles::compileAgain() {
    if (edited) {
        edited->again();
    }
}

}  // namespace raytorus::viewer
