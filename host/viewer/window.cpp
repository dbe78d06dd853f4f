// SPDX-License-Identifier: MIT
#include "viewer/window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/console.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "gpu/result.hpp"

namespace raytorus::viewer {
namespace {

std::string lastGlfwError() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description != nullptr ? description : "GLFW does not say why";
}

// Xlib calls it where the connection to the display breaks, and ends the program with code 1 if it returns.
int endWithoutDisplay(void* /*display*/) {
    removeUnfinishedFiles();
    writeError("raytorus-view: the connection to the display has broken\n");
    std::fflush(nullptr);
    std::_Exit(static_cast<int>(ExitCode::DeviceLost));
}

void expectLossOfDisplay() {
    using Handler = int (*)(void*);
    // Where GLFW has loaded Xlib. Nothing else of ours needs it.
    void* const function = dlsym(RTLD_DEFAULT, "XSetIOErrorHandler");
    if (function != nullptr) {
        reinterpret_cast<Handler (*)(Handler)>(function)(endWithoutDisplay);
    }
}

void start() {
    if (glfwInit() != GLFW_TRUE) {
        throw Error(
            ExitCode::NoDevice,
            fmt::format("no window can be opened ({}): is there a display, and is DISPLAY or WAYLAND_DISPLAY "
                        "set? Without one, raytorus render draws to a file and xvfb-run lends a display",
                        lastGlfwError()));
    }
    expectLossOfDisplay();
    if (glfwVulkanSupported() != GLFW_TRUE) {
        const std::string reason = lastGlfwError();
        glfwTerminate();
        throw Error(ExitCode::NoDevice,
                    fmt::format("no Vulkan driver was found that can draw to windows ({})", reason));
    }
}

}  // namespace

struct Window::Callbacks {
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    static void add(GLFWwindow* window, InputEvent event) { of(window).events.push_back(std::move(event)); }

    // Pointer positions come in the window's own units, which HiDPI makes others than pixels.
    static void addPointer(GLFWwindow* window, InputEvent event, double x, double y) {
        int width = 1;
        int height = 1;
        glfwGetWindowSize(window, &width, &height);
        const VkExtent2D pixels = of(window).framebufferSize();
        event.x = x * pixels.width / std::max(width, 1);
        event.y = y * pixels.height / std::max(height, 1);
        add(window, std::move(event));
    }

    static void key(GLFWwindow* window, int code, int, int action, int modifiers) {
        InputEvent event;
        event.code = code;
        event.pressed = action != GLFW_RELEASE;
        event.repeated = action == GLFW_REPEAT;
        event.modifiers = modifiers;
        add(window, event);
    }

    static void button(GLFWwindow* window, int code, int action, int modifiers) {
        InputEvent event;
        event.type = InputEvent::Type::Button;
        event.code = code;
        event.pressed = action == GLFW_PRESS;
        event.modifiers = modifiers;
        // Where the pointer was then. glfwGetCursorPos() tells where it is now, which may be the end of a
        // quick drag.
        addPointer(window, event, of(window).pointerX, of(window).pointerY);
    }

    static void move(GLFWwindow* window, double x, double y) {
        InputEvent event;
        event.type = InputEvent::Type::Move;
        of(window).pointerX = x;
        of(window).pointerY = y;
        addPointer(window, event, x, y);
    }

    // On Wayland a pointer that enters does not count as moved.
    static void enter(GLFWwindow* window, int) {
        glfwGetCursorPos(window, &of(window).pointerX, &of(window).pointerY);
    }

    static void scroll(GLFWwindow* window, double x, double y) {
        InputEvent event;
        event.type = InputEvent::Type::Scroll;
        event.x = x;
        event.y = y;
        add(window, event);
    }

    static void drop(GLFWwindow* window, int count, const char** paths) {
        if (count > 0) {
            InputEvent event;
            event.type = InputEvent::Type::Drop;
            event.text = paths[0];
            add(window, std::move(event));
        }
    }

    static void refreshed(GLFWwindow* window) { of(window).refresh = true; }
    static void resized(GLFWwindow* window, int, int) { of(window).refresh = true; }
    static void iconified(GLFWwindow* window, int) { of(window).refresh = true; }
    static void scaled(GLFWwindow* window, float, float) { of(window).refresh = true; }
};

Window::Window(const std::string& title, int width, int height) {
    start();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window = glfwCreateWindow(width, height, printable(title).c_str(), nullptr, nullptr);
    if (window == nullptr) {
        const std::string reason = lastGlfwError();
        glfwTerminate();
        throw Error(ExitCode::NoDevice, fmt::format("no window could be opened: {}", reason));
    }
    glfwSetWindowUserPointer(window, this);
    glfwGetCursorPos(window, &pointerX, &pointerY);
    glfwSetKeyCallback(window, &Callbacks::key);
    glfwSetMouseButtonCallback(window, &Callbacks::button);
    glfwSetCursorPosCallback(window, &Callbacks::move);
    glfwSetCursorEnterCallback(window, &Callbacks::enter);
    glfwSetScrollCallback(window, &Callbacks::scroll);
    glfwSetDropCallback(window, &Callbacks::drop);
    glfwSetWindowRefreshCallback(window, &Callbacks::refreshed);
    glfwSetFramebufferSizeCallback(window, &Callbacks::resized);
    glfwSetWindowIconifyCallback(window, &Callbacks::iconified);
    glfwSetWindowContentScaleCallback(window, &Callbacks::scaled);
}

Window::~Window() {
    glfwDestroyWindow(window);
    glfwTerminate();
}

std::vector<const char*> Window::instanceExtensions() {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr) {
        throw Error(
            ExitCode::NoDevice,
            "no Vulkan driver was found that can draw to this display's windows: install one (Debian: "
            "mesa-vulkan-drivers has one that needs no GPU), or correct VK_DRIVER_FILES / "
            "VK_ICD_FILENAMES if you set them");
    }
    return {names, names + count};
}

VkSurfaceKHR Window::makeSurface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    gpu::check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "glfwCreateWindowSurface");
    return surface;
}

std::vector<InputEvent> Window::poll(double seconds) {
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    return std::exchange(events, {});
}

bool Window::closed() const {
    return glfwWindowShouldClose(window) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(window, GLFW_TRUE);
}

VkExtent2D Window::framebufferSize() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    if (glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE) {
        return {0, 0};
    }
    return {static_cast<std::uint32_t>(std::max(width, 0)), static_cast<std::uint32_t>(std::max(height, 0))};
}

float Window::contentScale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(window, &x, &y);
    return std::max(std::max(x, y), 0.5F);
}

void Window::toggleFullScreen() {
    if (glfwGetWindowMonitor(window) != nullptr) {
        glfwSetWindowMonitor(window, nullptr, restoreX, restoreY, restoreWidth, restoreHeight,
                             GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) {
        return;
    }
    glfwGetWindowPos(window, &restoreX, &restoreY);
    glfwGetWindowSize(window, &restoreWidth, &restoreHeight);
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::minimise() {
    glfwIconifyWindow(window);
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(window, text.c_str());
}

bool Window::takeRefresh() {
    return std::exchange(refresh, false);
}

}  // namespace raytorus::viewer
