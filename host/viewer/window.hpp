// SPDX-License-Identifier: MIT
// The window and what a hand does to it.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <vector>

struct GLFWwindow;

namespace raytorus::viewer {

struct InputEvent {
    enum class Type { Key, Button, Move, Scroll, Drop };
    Type type = Type::Key;
    int code = 0;  ///< GLFW's key or mouse button
    bool pressed = false;
    bool repeated = false;
    int modifiers = 0;  ///< GLFW_MOD_...
    double x = 0.0;     ///< the pointer in framebuffer pixels, or the wheel's way
    double y = 0.0;
    std::string text;  ///< Drop: the first file
};

class Window {
public:
    /// Throws Error{NoDevice} where there is no display, and where GLFW cannot make Vulkan windows.
    Window(const std::string& title, int width, int height);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    [[nodiscard]] GLFWwindow* get() const { return window; }

    /// What a Vulkan instance needs for it.
    [[nodiscard]] static std::vector<const char*> instanceExtensions();

    /// The caller destroys it.
    [[nodiscard]] VkSurfaceKHR makeSurface(VkInstance instance) const;

    /// What has happened since the last call. `seconds`: how long to wait if nothing has.
    std::vector<InputEvent> poll(double seconds);

    [[nodiscard]] bool closed() const;
    void close();
    [[nodiscard]] VkExtent2D framebufferSize() const;  ///< 0 x 0 while minimised
    [[nodiscard]] float contentScale() const;
    void toggleFullScreen();
    void minimise();
    void setClipboard(const std::string& text);

    /// Whether the window's contents were damaged or its size changed since the last call.
    bool takeRefresh();

private:
    struct Callbacks;

    GLFWwindow* window = nullptr;
    std::vector<InputEvent> events;
    bool refresh = true;
    double pointerX = 0.0, pointerY = 0.0;  // in the window's own units, as the events so far tell
    int restoreX = 0, restoreY = 0, restoreWidth = 0, restoreHeight = 0;
};

}  // namespace raytorus::viewer
