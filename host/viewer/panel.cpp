// SPDX-License-Identifier: MIT
#include "viewer/panel.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

#include "viewer/gui.hpp"
#include "viewer/legend.hpp"

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
    if (state.view == View::Steps) {
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

void chooseMethods(State& state, const std::vector<MethodEntry>& methods) {
    chooseSide("Method", state.left, methods);
    ImGui::Checkbox("Wipe (W)", &state.wipe);
    if (state.wipe) {
        chooseSide("Right", state.right, methods);
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

void showStatistics(const State& state, const PanelInfo& info) {
    const Statistics& shown = state.statistics;
    ImGui::Text("%u x %u, %d sample%s a pixel", shown.extent.width, shown.extent.height, shown.samples,
                shown.samples == 1 ? "" : "s");
    ImGui::Text("%.1f frames a second", shown.framesPerSecond);
    const double rays = static_cast<double>(shown.extent.width) * shown.extent.height * shown.samples;
    ImGui::Text("picture: %.2f ms, on the device %.2f ms", 1e3 * shown.drawSeconds,
                1e3 * shown.deviceSeconds);
    if (shown.compiled) {
        ImGui::TextUnformatted("the driver compiled within that time");
    } else if (shown.drawSeconds > 0.0) {
        ImGui::Text("%.1f million camera rays a second", 1e-6 * rays / shown.drawSeconds);
    }
    ImGui::PushTextWrapPos(0.0F);
    drawWords(info.device);
    if (needsAnalysis(state.view) && state.view != View::Golden) {
        ImGui::Text("reference: %.0f %% of the pixels, %lld wrong, largest difference %.3g roundings",
                    100.0 * shown.analysed, shown.wrongPixels, shown.largestError);
    }
    if (state.view == View::Golden && !state.goldenSentence.empty()) {
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

void drawPanel(State& state, const PanelInfo& info) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float width = 21.0F * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x - 8.0F, 8.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, size.y - 16.0F});
    const bool focus = std::exchange(state.panelFocusRequest, false);
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
        chooseMethods(state, *info.methods);
        int samples = state.samplesPerSide;
        const std::string text = fmt::format("{} a pixel", samples * samples);
        if (ImGui::SliderInt("Samples", &samples, 1, 16, text.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
            state.samplesPerSide = samples;
        }
        if (info.animated) {
            ImGui::Separator();
            chooseTime(state);
        }
        ImGui::Separator();
        showStatistics(state, info);
        ImGui::Separator();
        drawScenePanel(state);
        ImGui::Separator();
        ImGui::TextDisabled("H: keys   Tab: this panel   click: a pixel");
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

}  // namespace raytorus::viewer
