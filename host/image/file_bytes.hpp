// SPDX-License-Identifier: MIT
// Whole files in and out of memory. Every failure is an Error{ExitCode::File} with the file and the reason.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace raytorus::image {

[[nodiscard]] std::vector<std::byte> readBytes(const std::filesystem::path& path);

/// Readers see the old file or the new one, never a part: the bytes go to a temporary file beside `path`,
/// which then takes its place. After an error the old file is as it was and nothing else is left. (A power
/// cut is not covered.)
void writeBytes(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace raytorus::image
