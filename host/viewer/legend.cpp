// SPDX-License-Identifier: MIT
#include "viewer/legend.hpp"

#include <imgui.h>

#include <array>
#include <span>

#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

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

}  // namespace

void drawLegend(const State& state) {
    const std::array ramp = {VIEW_RAMP(rgb)};
    const std::array errors = {VIEW_ERROR_RAMP(rgb)};
    switch (state.view) {
        case View::Count:
            drawRamp(ramp, std::array{"0", "2", "4", "6", "8"});
            patch(rgb(0.15, 0.75, 0.35), "odd: the camera is in a solid");
            break;
        case View::Steps: {
            drawRamp(ramp, std::array{"0", "half", "most"});
            ImGui::Text("most: %d steps", state.mostSteps);
            break;
        }
        case View::Surface:
        case View::Reference:
            drawRamp(errors, std::array{".1", "1", "10", "100", "1e3", "1e4", "1e5", "1e6"});
            ImGui::TextUnformatted("roundings (2^-24 of the size); promised: 1.5");
            patch(rgb(1.0, 0.0, 0.85), "wrong: hit or miss, torus, or count");
            break;
        case View::Golden:
            patch(rgb(0.1, 0.3, 0.8), "within the golden's tolerance");
            patch(rgb(1.0, 0.6, 0.1), "over it");
            patch(rgb(0.1, 0.8, 0.2), "a flip where it leaves the value open");
            break;
        default:
            break;
    }
}

}  // namespace raytorus::viewer
