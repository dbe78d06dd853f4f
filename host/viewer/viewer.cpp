// SPDX-License-Identifier: MIT
#include "viewer/viewer.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "scene/scene_json.hpp"
#include "viewer/viewer_loop.hpp"

namespace raytorus::viewer {
namespace {

State firstState(const ViewerOptions& options, const std::vector<MethodEntry>& methods) {
    State state;
    state.sceneFile = options.scene;
    state.fileScene = scene::readScene(options.scene);
    state.scene = state.fileScene;
    state.view = options.view;
    state.methodCount = methods.size();
    const std::string method = !options.method.empty() ? options.method
                               : methods.back().edited ? "edited"
                                                       : "raytorus";
    const std::string right = !options.wipeMethod.empty() ? options.wipeMethod : "closed-form-naive";
    state.left = {indexOf(methods, method), options.route};
    state.right = {indexOf(methods, right), options.route};
    state.wipe = !options.wipeMethod.empty();
    state.wipeAt = options.wipeAt;
    state.samplesPerSide = options.samplesPerSide;
    state.animation.seconds = options.time;
    state.animation.playing = !options.paused;
    state.panel = options.panel;
    state.help = options.help;
    state.pickRequest = options.pick;
    return state;
}

}  // namespace

void runViewer(const ViewerOptions& options) {
    std::vector<MethodEntry> methods = methodList(!options.edit.empty());
    State state = firstState(options, methods);
    const int width = options.width > 0 ? options.width : state.scene.imageWidth;
    const int height = options.height > 0 ? options.height : state.scene.imageHeight;
    Window window(fmt::format("{} - raytorus", std::filesystem::path(options.scene).filename().string()),
                  width, height);
    options::DeviceOptions device = options.device;
    device.context.instanceExtensions = Window::instanceExtensions();
    device.context.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    options::withDevice(device, [&](gpu::Context& context) {
        ViewerLoop(options, window, context, std::move(state), std::move(methods)).run();
    });
}

}  // namespace raytorus::viewer
