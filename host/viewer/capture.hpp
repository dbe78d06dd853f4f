// SPDX-License-Identifier: MIT
// Pictures and scenes into files, under names that are still free.
#pragma once

#include <filesystem>
#include <string>

#include "image/image.hpp"
#include "viewer/pictures.hpp"
#include "viewer/view_pass.hpp"

namespace raytorus::viewer {

/// "<stem>-001<extension>", or the first number after it for which there is no file in the folder yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& extension);

/// A picture as displayed (R, G, B in [0, 1], multiples of 1/255 or nearly), into a PNG of these values.
void writeDisplayed(const std::filesystem::path& path, image::Image displayed);

/// The picture of the left side, into an .exr file with every channel, or into a .png as the view shows it.
void writePicture(const std::filesystem::path& path, View view, Pictures& pictures, ViewPass& viewPass);

}  // namespace raytorus::viewer
