// SPDX-License-Identifier: MIT
// A scene held to its golden picture, to be looked at.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gpu/context.hpp"
#include "image/image.hpp"
#include "render/picture_drawing.hpp"
#include "viewer/analysis.hpp"

namespace raytorus::viewer {

struct Golden {
    std::string name;  ///< of its file
    image::Image truth;
    int samplesPerSide = 1;  ///< it was made with
};

/// The golden picture that a file holds.
Golden readGolden(const std::filesystem::path& file);

/// The golden picture of a scene that lies in the folder `scenes` of a set of them (docs/golden.md). Nothing
/// for other scenes.
std::optional<Golden> findGolden(const std::filesystem::path& scene);

struct GoldenView {
    AnalysisPixels pixels;  ///< the picture of the differences, compare::differenceImage
    std::string sentence;   ///< what the comparison comes to
    bool passed = false;
};

/// Draws the scene in the golden picture's size and compares.
GoldenView compareWithGolden(gpu::Context& context, const scene::Scene& scene, const Golden& golden,
                             const trace::ShaderSource& shaders, render::Route route);

}  // namespace raytorus::viewer
