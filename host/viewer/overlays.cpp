// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/gui.hpp"
#include "viewer/keys.hpp"
#include "viewer/panels.hpp"

namespace raytorus::viewer {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
constexpr ImGuiWindowFlags bare = plain | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                                  ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Where the picture is, in the units of the window.
struct Place {
    float x, y, width, height;
};

// The group of keys that begins the right half of the help.
constexpr std::string_view secondColumn = "Method";

void drawHelp(State& state) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(size.x - 16.0F, 72.0F * ImGui::GetFontSize()), size.y - 32.0F},
                             ImGuiCond_Always);
    if (ImGui::Begin("Keys (H or ? closes)", &state.help, plain | ImGuiWindowFlags_NoMove)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_None)) {
            std::string_view group;
            ImGui::TableNextColumn();
            for (const KeyBinding& binding : keyBindings()) {
                if (group != binding.group && binding.group == secondColumn) {
                    ImGui::TableNextColumn();
                }
                if (group != binding.group) {
                    group = binding.group;
                    ImGui::TextColored({0.55F, 0.75F, 1.0F, 1.0F}, "%s", binding.group);
                }
                ImGui::Text("  %s", binding.keys);
                ImGui::SameLine(8.0F * ImGui::GetFontSize());
                ImGui::TextUnformatted(binding.description);
            }
            ImGui::TextColored({0.55F, 0.75F, 1.0F, 1.0F}, "Pointer");
            for (const Gesture& gesture : gestures()) {
                ImGui::Text("  %s: %s", gesture.gesture, gesture.description);
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

void drawPick(State& state, CommandQueue& commands) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float width = std::min(0.62F * size.x, 66.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({8.0F, size.y - 8.0F}, ImGuiCond_Appearing, {0.0F, 1.0F});
    ImGui::SetNextWindowSize({width, 0.5F * size.y}, ImGuiCond_Appearing);
    bool open = true;
    if (ImGui::Begin("Pixel", &open, plain)) {
        if (ImGui::Button("Copy command (C)")) {
            commands.push(CopyText{state.pick->command});
        }
        ImGui::SameLine();
        if (ImGui::Button("Copy test case (Shift+C)")) {
            commands.push(CopyText{state.pick->testCase});
        }
        ImGui::Separator();
        ImGui::BeginChild("explanation", {0.0F, 0.0F}, false, ImGuiWindowFlags_HorizontalScrollbar);
        ImGui::PushFont(monospacedFont());
        drawWords(state.pick->text);
        ImGui::PopFont();
        ImGui::EndChild();
    }
    ImGui::End();
    if (!open) {
        state.pick.reset();
    }
}

// Crosshairs round the pixel that is taken apart.
void drawMarker(const State& state, const Place& picture) {
    const VkExtent2D extent = state.statistics.extent;
    if (extent.width == 0 || extent.height == 0) {
        return;
    }
    const float x = picture.x + (static_cast<float>(state.pick->x) + 0.5F) /
                                    static_cast<float>(extent.width) * picture.width;
    const float y = picture.y + (static_cast<float>(state.pick->y) + 0.5F) /
                                    static_cast<float>(extent.height) * picture.height;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddCircle({x, y}, 7.0F, IM_COL32(0, 0, 0, 255), 24, 3.0F);
    list->AddCircle({x, y}, 7.0F, IM_COL32(255, 255, 255, 255), 24, 1.5F);
}

void drawWipe(const State& state, const Place& picture) {
    const float x = picture.x + static_cast<float>(state.wipeAt) * picture.width;
    const float top = picture.y;
    const float bottom = top + picture.height;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddLine({x, top}, {x, bottom}, IM_COL32(0, 0, 0, 160), 4.0F);
    list->AddLine({x, top}, {x, bottom}, IM_COL32(255, 255, 255, 230), 1.5F);
    const auto label = [&](const Side& side) {
        const std::string& name = state.methods[side.method].name;
        return state.left.route == state.right.route ? name : name + ", " + render::infoOf(side.route).name;
    };
    const std::string left = label(state.left);
    const std::string right = label(state.right);
    const float gap = 0.5F * ImGui::GetFontSize();
    const float y = bottom - 1.8F * ImGui::GetFontSize();
    const auto write = [&](float at, const std::string& text) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        list->AddRectFilled({at - 4.0F, y - 2.0F}, {at + size.x + 4.0F, y + size.y + 2.0F},
                            IM_COL32(0, 0, 0, 170), 3.0F);
        list->AddText({at, y}, IM_COL32_WHITE, text.c_str());
    };
    write(x - gap - ImGui::CalcTextSize(left.c_str()).x, left);
    write(x + gap, right);
}

void drawError(const State& state) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 8.0F}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {size.x - 16.0F, 0.6F * size.y});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.35F, 0.05F, 0.05F, 0.94F));
    if (ImGui::Begin("Shader error", nullptr, bare)) {
        ImGui::TextUnformatted("The edited shaders do not compile; the last good picture stays.");
        ImGui::PushFont(monospacedFont());
        ImGui::PushTextWrapPos(size.x - 32.0F);
        drawWords(state.shaderError);
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

void drawMessage(const State& state) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, size.y - 8.0F}, ImGuiCond_Always, {0.5F, 1.0F});
    if (ImGui::Begin("Message", nullptr, bare)) {
        ImGui::PushTextWrapPos(std::max(200.0F, size.x - 64.0F));
        drawWords(state.message.text);
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

}  // namespace

void drawOverlays(State& state, CommandQueue& commands, VkRect2D pixels, double now) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;  // ImGui counts in the window's units
    const Place picture{static_cast<float>(pixels.offset.x) / scale.x,
                        static_cast<float>(pixels.offset.y) / scale.y,
                        static_cast<float>(pixels.extent.width) / scale.x,
                        static_cast<float>(pixels.extent.height) / scale.y};
    if (state.wipe) {
        drawWipe(state, picture);
    }
    if (state.pick) {
        drawMarker(state, picture);
        drawPick(state, commands);
    }
    if (!state.shaderError.empty()) {
        drawError(state);
    }
    if (now < state.message.until) {
        drawMessage(state);
    }
    if (state.help) {
        drawHelp(state);
    }
}

}  // namespace raytorus::viewer
