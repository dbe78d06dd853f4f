// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <span>

#include "viewer/gui.hpp"
#include "viewer/panels.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

void tip(const char* text) {
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(24.0F * ImGui::GetFontSize());
        ImGui::TextUnformatted(text);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

ImVec4 rgb(double red, double green, double blue) {
    return {static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue), 1.0F};
}

// A bar through the stops, and under it words at its ends and in between.
void drawRamp(std::span<const ImVec4> stops, std::span<const char* const> marks) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = 0.7F * ImGui::GetTextLineHeight();
    const float step = width / static_cast<float>(stops.size() - 1);
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const ImU32 left = ImGui::ColorConvertFloat4ToU32(stops[i]);
        const ImU32 right = ImGui::ColorConvertFloat4ToU32(stops[i + 1]);
        const float x = from.x + static_cast<float>(i) * step;
        list->AddRectFilledMultiColor({x, from.y}, {x + step, from.y + height}, left, right, right, left);
    }
    ImGui::Dummy({width, height});
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(marks.size() - 1);
        const float textWidth = ImGui::CalcTextSize(marks[i]).x;
        if (i > 0) {
            ImGui::SameLine();
        }
        ImGui::SetCursorScreenPos({from.x + part * (width - textWidth), ImGui::GetCursorScreenPos().y});
        ImGui::TextUnformatted(marks[i]);
    }
}

void patch(ImVec4 color, const char* meaning) {
    const float size = ImGui::GetTextLineHeight();
    ImGui::ColorButton(meaning, color, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                       {size, size});
    ImGui::SameLine();
    ImGui::TextUnformatted(meaning);
}

// What the colours of the view mean; nothing for views that need none.
void drawLegend(const State& state) {
    const std::array ramp = {VIEW_RAMP(rgb)};
    const std::array errors = {VIEW_ERROR_RAMP(rgb)};
    switch (state.view) {
        case PictureView::Count:
            drawRamp(ramp, std::array{"0", "2", "4", "6", "8"});
            patch(rgb(0.15, 0.75, 0.35), "odd: the camera is in a solid");
            break;
        case PictureView::Steps: {
            drawRamp(ramp, std::array{"0", "half", "most"});
            ImGui::Text("most: %d steps", state.mostSteps);
            break;
        }
        case PictureView::Surface:
        case PictureView::Reference:
            drawRamp(errors, std::array{".1", "1", "10", "100", "1e3", "1e4", "1e5", "1e6"});
            ImGui::TextUnformatted("roundings (2^-24 of the size)\npromised: 1.5");
            patch(rgb(1.0, 0.0, 0.85), "wrong: hit or miss, torus, or count");
            break;
        case PictureView::Golden:
            patch(rgb(0.1, 0.3, 0.8), "within the golden's tolerance");
            patch(rgb(1.0, 0.6, 0.1), "over it");
            patch(rgb(0.1, 0.8, 0.2), "a flip where it leaves the value open");
            break;
        default:
            break;
    }
}

void chooseView(State& state) {
    if (ImGui::BeginCombo("View", infoOf(state.view).title)) {
        for (const ViewInfo& info : views()) {
            if (ImGui::Selectable(info.title, info.view == state.view)) {
                state.view = info.view;
            }
            tip(info.description);
        }
        ImGui::EndCombo();
    }
    tip(infoOf(state.view).description);
    if (state.view == PictureView::Steps) {
        ImGui::SliderInt("Most steps", &state.mostSteps, 4, 256, "%d", ImGuiSliderFlags_Logarithmic);
    }
    drawLegend(state);
}

void chooseSide(const char* label, Side& side, const std::vector<MethodEntry>& methods) {
    ImGui::PushID(label);
    if (ImGui::BeginCombo(label, methods[side.method].name.c_str())) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            if (ImGui::Selectable(methods[i].name.c_str(), i == side.method)) {
                side.method = i;
            }
            tip(methods[i].description.c_str());
        }
        ImGui::EndCombo();
    }
    tip(methods[side.method].description.c_str());
    for (const render::RouteInfo& info : render::routes) {
        if (ImGui::RadioButton(info.name, side.route == info.route)) {
            side.route = info.route;
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::PopID();
}

void chooseMethods(State& state) {
    chooseSide("Method", state.left, state.methods);
    ImGui::Checkbox("Wipe (W)", &state.wipe);
    if (state.wipe) {
        chooseSide("Right", state.right, state.methods);
        auto at = static_cast<float>(state.wipeAt);
        if (ImGui::SliderFloat("Wipe at", &at, 0.0F, 1.0F, "%.2f")) {
            state.wipeAt = static_cast<double>(at);
        }
    }
}

void chooseTime(State& state) {
    Animation& animation = state.animation;
    if (ImGui::Button(animation.playing ? "Pause" : "Play")) {
        animation.playing = !animation.playing;
    }
    ImGui::SameLine();
    if (ImGui::Button("Begin")) {
        animation.seconds = 0.0;
    }
    ImGui::SameLine();
    ImGui::Text("%.2f s", animation.seconds);
    const double least = 1.0 / 64.0;
    const double most = 64.0;
    ImGui::SliderScalar("Speed", ImGuiDataType_Double, &animation.speed, &least, &most, "%.3g x",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

void showStatistics(const State& state, const std::string& device) {
    const PictureStatistics& shown = state.statistics;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::Text("%u x %u, %d sample%s a pixel", shown.extent.width, shown.extent.height, shown.samples,
                shown.samples == 1 ? "" : "s");
    ImGui::Text("%.1f frames a second", shown.framesPerSecond);
    const double rays = static_cast<double>(shown.extent.width) * shown.extent.height * shown.samples;
    ImGui::Text("picture: %.4g ms, on the device %.4g ms", 1e3 * shown.drawSeconds,
                1e3 * shown.deviceSeconds);
    if (shown.compiled) {
        ImGui::TextUnformatted("the driver compiled within that time");
    } else if (shown.drawSeconds > 0.0) {
        ImGui::Text("%.1f million camera rays a second", 1e-6 * rays / shown.drawSeconds);
    }
    drawWords(device);
    if (needsAnalysis(state.view) && state.view != PictureView::Golden) {
        ImGui::Text("reference: %.0f %% of the pixels, %lld wrong, largest difference %.3g roundings",
                    100.0 * shown.analysed, shown.wrongPixels, shown.largestError);
    }
    if (state.view == PictureView::Golden && !state.goldenSentence.empty()) {
        drawWords(state.goldenSentence);
    }
    ImGui::PopTextWrapPos();
}

// The window that is being drawn has the keys, its first item to begin with. Gui takes them back.
void takeKeys() {
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

}  // namespace

void drawPanel(State& state, CommandQueue& commands, const std::string& device, bool focus) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float width = 21.0F * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x - 8.0F, 8.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, size.y - 16.0F});
    if (focus) {
        ImGui::SetNextWindowFocus();
    }
    if (ImGui::Begin(
            "raytorus", nullptr,
            ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) {
        if (focus) {
            takeKeys();
        }
        ImGui::PushItemWidth(0.62F * ImGui::GetContentRegionAvail().x);
        chooseView(state);
        ImGui::Separator();
        chooseMethods(state);
        int samples = state.samplesPerSide;
        const std::string text = fmt::format("{} a pixel", samples * samples);
        if (ImGui::SliderInt("Samples", &samples, 1, 16, text.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
            state.samplesPerSide = samples;
        }
        if (isAnimated(state)) {
            ImGui::Separator();
            chooseTime(state);
        }
        ImGui::Separator();
        showStatistics(state, device);
        ImGui::Separator();
        drawScenePanel(state, commands);
        ImGui::Separator();
        ImGui::TextDisabled("H: keys   Tab: this panel   click: a pixel");
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

}  // namespace raytorus::viewer
