// SPDX-License-Identifier: MIT
#include "viewer/gui.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

#include "core/console.hpp"
#include "gpu/result.hpp"

namespace raytorus::viewer {
namespace {

void checkResult(VkResult result) {
    gpu::check(result, "drawing the panels");
}

// The first of the fonts that is installed; ImGui's own where none is.
void addFont(std::span<const char* const> paths, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* path : paths) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path, ignored) &&
            io.Fonts->AddFontFromFileTTF(path, pixels) != nullptr) {
            return;
        }
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
}

void addFonts(float scale) {
    constexpr std::array text = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                 "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                 "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};
    constexpr std::array columns = {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                    "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
                                    "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf"};
    addFont(text, std::floor(13.0F * scale));
    addFont(columns, std::floor(13.0F * scale));
}

void setStyle(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 4.0F;
    style.FrameRounding = 3.0F;
    style.GrabRounding = 3.0F;
    style.WindowBorderSize = 0.0F;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.07F, 0.08F, 0.10F, 0.88F);
    style.Colors[ImGuiCol_Header] = ImVec4(0.20F, 0.30F, 0.45F, 0.6F);
    style.ScaleAllSizes(scale);
}

}  // namespace

void drawWords(std::string_view text) {
    const std::string words = printable(text);
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

ImFont* monospacedFont() {
    return ImGui::GetIO().Fonts->Fonts.back();
}

Gui::Gui(gpu::Context& context, const Window& window, const Swapchain& swapchain) : device(context.device()) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 4};
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    poolInfo.maxSets = 4;
    poolInfo.poolSizeCount = 1;
    poolInfo.pPoolSizes = &size;
    pool = gpu::create<vkDestroyDescriptorPool>(vkCreateDescriptorPool, context.scope(), poolInfo,
                                                "vkCreateDescriptorPool");
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is left behind in the folder that the program runs in
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    const float scale = window.contentScale();
    addFonts(scale);
    setStyle(scale);
    ImGui_ImplGlfw_InitForVulkan(window.get(), true);
    try {
        startDrawing(context, swapchain);
    } catch (...) {
        stop();  // a constructor that throws runs no destructor
        throw;
    }
}

void Gui::startDrawing(gpu::Context& context, const Swapchain& swapchain) {
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = context.instance();
    info.PhysicalDevice = context.info().handle;
    info.Device = device;
    info.QueueFamily = context.info().queueFamily;
    info.Queue = context.queue();
    info.DescriptorPool = pool.get();
    info.MinImageCount = 2;
    // Its vertex buffers go round by this number. Each frame is waited for, so the window's images may be
    // more.
    info.ImageCount = 2;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = checkResult;
    ImGui_ImplVulkan_Init(&info, swapchain.renderPass());
    context.submit([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Gui::~Gui() {
    stop();
}

void Gui::stop() const {
    vkDeviceWaitIdle(device);
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// From 1.87 on ImGui does this itself; before, a frame has the keys that are down when it begins.
void Gui::take([[maybe_unused]] const InputEvent& event) {
#if IMGUI_VERSION_NUM < 18700
    const bool key = event.type == InputEvent::Type::Key && !event.repeated;
    if (key && event.code >= 0 && static_cast<std::size_t>(event.code) < keysDown.size()) {
        keyEvents.push_back(event);
    }
#endif
}

void Gui::updateKeys() {
#if IMGUI_VERSION_NUM < 18700
    std::array<bool, 512> changed{};
    for (bool pressed = false; !keyEvents.empty(); keyEvents.pop_front()) {
        const InputEvent& event = keyEvents.front();
        const auto key = static_cast<std::size_t>(event.code);
        if (changed[key] || (event.pressed && pressed)) {
            break;
        }
        changed[key] = true;
        pressed = pressed || event.pressed;
        keysDown[key] = event.pressed;
    }
    ImGuiIO& io = ImGui::GetIO();
    std::ranges::copy(keysDown, io.KeysDown);
    io.KeyCtrl = keysDown[GLFW_KEY_LEFT_CONTROL] || keysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = keysDown[GLFW_KEY_LEFT_SHIFT] || keysDown[GLFW_KEY_RIGHT_SHIFT];
    io.KeyAlt = keysDown[GLFW_KEY_LEFT_ALT] || keysDown[GLFW_KEY_RIGHT_ALT];
    io.KeySuper = keysDown[GLFW_KEY_LEFT_SUPER] || keysDown[GLFW_KEY_RIGHT_SUPER];
#endif
}

void Gui::begin() {
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    updateKeys();
    // Panels have the keys when told to, until Esc or the pointer takes them away: arrows are the camera's.
    ImGuiIO& io = ImGui::GetIO();
    const bool had = io.NavVisible;
    ImGui::NewFrame();
    if (had && !io.NavVisible) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
}

void Gui::end() {
    ImGui::Render();
}

void Gui::draw(VkCommandBuffer commands, VkRenderPass pass, const FrameTarget& target) const {
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = pass;
    info.framebuffer = target.framebuffer;
    info.renderArea.extent = target.extent;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    if (ImDrawData* data = ImGui::GetDrawData(); data != nullptr) {
        ImGui_ImplVulkan_RenderDrawData(data, commands);
    }
    vkCmdEndRenderPass(commands);
}

bool Gui::takesPointer() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Gui::takesKeys() const {
    const ImGuiIO& io = ImGui::GetIO();
    return io.WantTextInput || io.NavVisible;
}

}  // namespace raytorus::viewer
