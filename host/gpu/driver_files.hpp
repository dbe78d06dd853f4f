// SPDX-License-Identifier: MIT
// The JSON files by which the Vulkan loader finds drivers. One that is damaged makes loader 1.3.239 fail, as
// if memory were short, or crash: the good ones beside it are hidden.
#pragma once

#include <string>
#include <vector>

namespace raytorus::gpu {

struct DriverFiles {
    std::vector<std::string> good;     ///< in the order in which the loader reads them
    std::vector<std::string> damaged;  ///< "\"file\": it is no JSON"
};

/// Those that the loader will read, by its variables and its folders.
[[nodiscard]] DriverFiles findDriverFiles();

/// Before the first instance is made. Where there is a damaged file, says so on standard error, and names the
/// others to the loader, in VK_DRIVER_FILES. Throws Error{NoDevice} where there is no other.
void leaveOutDamagedDrivers();

}  // namespace raytorus::gpu
