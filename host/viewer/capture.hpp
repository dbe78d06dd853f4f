// SPDX-License-Identifier: MIT
// Files that the window writes.
#pragma once

#include <vulkan/vulkan.h>

#include <filesystem>
#include <string>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace raytorus::viewer {

/// "<stem>-001<extension>", or the first number after it for which there is no file in the folder yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& extension);

/// A picture as displayed (R, G, B in [0, 1], multiples of 1/255 or nearly), into a PNG of these values.
void writeDisplayed(const std::filesystem::path& path, image::Image displayed);

/// The scene, with pictures of this size.
void writeScene(const std::filesystem::path& path, scene::Scene scene, VkExtent2D size);

}  // namespace raytorus::viewer
