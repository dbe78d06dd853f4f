// SPDX-License-Identifier: MIT
// Dear ImGui on the window: its set-up, its fonts, its frames. What is drawn with it is said elsewhere.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <deque>
#include <string_view>

#include "gpu/context.hpp"
#include "viewer/swapchain.hpp"
#include "viewer/window.hpp"

struct ImFont;

namespace raytorus::viewer {

/// For text in columns. Between Gui::begin() and Gui::end().
ImFont* monospacedFont();

/// Words from elsewhere: files, compilers, drivers. They are printable, and no format.
void drawWords(std::string_view text);

class Gui {
public:
    /// After the window's own callbacks are set: ImGui calls those first.
    Gui(gpu::Context& context, const Window& window, const Swapchain& swapchain);
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui();

    /// Keys for the panels. Each press has a frame of its own, so that neither a key that is up again by the
    /// next frame is lost, nor the order of two.
    void take(const InputEvent& event);
    [[nodiscard]] bool wantsFrame() const { return !keyEvents.empty(); }

    /// Between these two, ImGui's functions may be called.
    void begin();
    void end();

    /// What was drawn between the last begin() and end(), over a frame in
    /// VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL.
    void draw(VkCommandBuffer commands, VkRenderPass pass, const FrameTarget& target) const;

    /// Whether the pointer is on a panel, and whether a text field takes the keys.
    [[nodiscard]] bool takesPointer() const;
    [[nodiscard]] bool takesKeys() const;

private:
    void startDrawing(gpu::Context& context, const Swapchain& swapchain);
    void stop() const;
    void updateKeys();

    gpu::Handle<VkDescriptorPool, vkDestroyDescriptorPool> pool;
    VkDevice device;
    std::deque<InputEvent> keyEvents;  // those that no frame has had yet
    std::array<bool, 512> keysDown{};  // by GLFW's numbers, as the last frame had them
};

}  // namespace raytorus::viewer
