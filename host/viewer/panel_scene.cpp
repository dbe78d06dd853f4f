// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/console.hpp"
#include "viewer/panels.hpp"

namespace raytorus::viewer {
namespace {

constexpr double tiny = 1e-6;
constexpr double huge = 1e6;

// A drag that changes the value by parts of its own size.
bool dragSize(const char* label, double& value, double least) {
    const float speed = static_cast<float>(std::max(1e-4, 0.005 * std::abs(value)));
    const double most = huge;
    return ImGui::DragScalar(label, ImGuiDataType_Double, &value, speed, &least, &most, "%.6g",
                             ImGuiSliderFlags_AlwaysClamp);
}

bool dragVector(const char* label, glm::dvec3& value, float speed) {
    const double least = -huge;
    const double most = huge;
    return ImGui::DragScalarN(label, ImGuiDataType_Double, &value.x, 3, speed, &least, &most, "%.4g",
                              ImGuiSliderFlags_AlwaysClamp);
}

// Linear RGB, edited as numbers and by ImGui's picker.
bool editColor(const char* label, glm::dvec3& color, bool bright) {
    float values[3] = {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z)};
    const ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_Float | (bright ? ImGuiColorEditFlags_HDR : ImGuiColorEditFlags_None);
    if (!ImGui::ColorEdit3(label, values, flags)) {
        return false;
    }
    const float most = bright ? 1e6F : 1.0F;
    for (int i = 0; i < 3; ++i) {
        color[i] = static_cast<double>(std::clamp(values[i], 0.0F, most));
    }
    return true;
}

void editRotation(scene::TorusInstance& torus) {
    // The turn since the drag began is added to the rotation: Euler angles of their own would jump.
    glm::dvec3 turn(0.0);
    if (ImGui::DragScalarN("Turn x y z", ImGuiDataType_Double, &turn.x, 3, 0.5F, nullptr, nullptr, "drag")) {
        const glm::dquat step(glm::radians(turn));
        torus.rotation = glm::normalize(step * torus.rotation);
    }
    if (ImGui::Button("Upright")) {
        torus.rotation = glm::dquat(1.0, 0.0, 0.0, 0.0);
    }
}

// That prints a name and no number, whatever the name holds.
std::string formatOf(const std::string& name) {
    std::string format;
    for (const char c : printable(name)) {
        format += c == '%' ? std::string("%%") : std::string(1, c);
    }
    return format;
}

void editTorus(State& state) {
    scene::Scene& scene = state.scene;
    int index = static_cast<int>(state.selectedTorus);
    const int last = static_cast<int>(scene.tori.size()) - 1;
    if (last > 0) {
        ImGui::SliderInt("Torus", &index, 0, last, "%d", ImGuiSliderFlags_AlwaysClamp);
        state.selectedTorus = static_cast<std::size_t>(index);
    }
    scene::TorusInstance& torus = scene.tori[state.selectedTorus];
    dragSize("Major radius", torus.majorRadius, 0.0);
    dragSize("Minor radius", torus.minorRadius, tiny);
    ImGui::Text("r/R = %.4g", torus.minorRadius / torus.majorRadius);
    dragVector("Place", torus.translation, 0.01F);
    editRotation(torus);
    dragSize("Scale", torus.scale, tiny);
    if (scene.materials.size() > 1) {
        int material = static_cast<int>(torus.materialIndex);
        const std::string name = formatOf(scene.materials[torus.materialIndex].name);
        ImGui::SliderInt("Its material", &material, 0, static_cast<int>(scene.materials.size()) - 1,
                         name.c_str(), ImGuiSliderFlags_AlwaysClamp);
        torus.materialIndex = static_cast<std::size_t>(material);
    }
}

void editMaterial(scene::Material& material) {
    editColor("Diffuse", material.diffuse, false);
    editColor("Specular", material.specular, false);
    const double least = 0.01;
    const double most = 1.0;
    ImGui::SliderScalar("Roughness", ImGuiDataType_Double, &material.roughness, &least, &most, "%.3g",
                        ImGuiSliderFlags_AlwaysClamp);
    bool checker = material.checker.has_value();
    if (ImGui::Checkbox("UV checker", &checker)) {
        material.checker = checker ? std::optional(scene::Checker{}) : std::nullopt;
    }
    if (material.checker) {
        int counts[2] = {material.checker->countU / 2, material.checker->countV / 2};
        if (ImGui::SliderInt2("Pairs of fields", counts, 1, 64, "%d", ImGuiSliderFlags_AlwaysClamp)) {
            material.checker->countU = 2 * counts[0];
            material.checker->countV = 2 * counts[1];
        }
        editColor("Other fields", material.checker->diffuse, false);
    }
}

void editLights(scene::Scene& scene) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        scene::Light& light = scene.lights[i];
        ImGui::PushID(static_cast<int>(i));
        const bool point = light.type == scene::Light::Type::Point;
        glm::dvec3 vector = light.vector;
        if (dragVector(point ? "Position" : "Direction to it", vector, 0.01F) &&
            (point || glm::length(vector) > tiny)) {
            light.vector = vector;
        }
        editColor(point ? "Intensity" : "Radiance", light.color, true);
        if (ImGui::SmallButton("Remove this light")) {
            scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(i));
            ImGui::PopID();
            break;
        }
        ImGui::PopID();
    }
    if (scene.lights.size() < scene::maxLights && ImGui::SmallButton("Add a light")) {
        scene.lights.push_back({scene::Light::Type::Directional, {-0.5, -0.5, 1.0}, glm::dvec3(0.5)});
    }
    editColor("Ambient sky", scene.ambient.sky, true);
    editColor("Ambient ground", scene.ambient.ground, true);
    editColor("Background top", scene.background.top, true);
    editColor("Background bottom", scene.background.bottom, true);
}

void editCamera(State& state) {
    scene::Camera moved = state.scene.camera;
    dragVector("Position", moved.position, 0.02F);
    dragVector("Target", moved.target, 0.02F);
    const double least = 0.001;
    const double most = 170.0;
    ImGui::DragScalar("Field of view", ImGuiDataType_Double, &moved.verticalFieldOfView, 0.1F, &least, &most,
                      "%.3g degrees", ImGuiSliderFlags_AlwaysClamp);
    const glm::dvec3 sight = moved.target - moved.position;
    const bool looks = glm::length(glm::cross(sight, moved.up)) > tiny * glm::length(sight);
    if (looks && glm::length(sight) > 0.0) {
        state.scene.camera = moved;
    }
}

}  // namespace

void drawScenePanel(State& state, CommandQueue& commands) {
    if (ImGui::CollapsingHeader("Torus", ImGuiTreeNodeFlags_DefaultOpen)) {
        ImGui::PushID("torus");
        editTorus(state);
        ImGui::PopID();
    }
    if (ImGui::CollapsingHeader("Material")) {
        ImGui::PushID("material");
        editMaterial(state.scene.materials[state.scene.tori[state.selectedTorus].materialIndex]);
        ImGui::PopID();
    }
    if (ImGui::CollapsingHeader("Lights")) {
        ImGui::PushID("lights");
        editLights(state.scene);
        ImGui::PopID();
    }
    if (ImGui::CollapsingHeader("Camera")) {
        ImGui::PushID("camera");
        editCamera(state);
        ImGui::PopID();
    }
    if (ImGui::Button("Save scene")) {
        commands.push(SaveScene{});
    }
    ImGui::SameLine();
    if (ImGui::Button("Undo all")) {
        state.scene = state.fileScene;
    }
}

}  // namespace raytorus::viewer
