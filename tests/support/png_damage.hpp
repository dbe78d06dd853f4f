// SPDX-License-Identifier: MIT
// PNG files that are wrong in a way that no checksum tells.
#pragma once

#include <cstdint>
#include <string>

namespace raytorus::test {

/// The file with a header that promises another size than it has.
std::string promising(std::string png, std::uint32_t width, std::uint32_t height);

/// The file with another byte among its compressed pixels.
std::string withDamagedData(std::string png);

}  // namespace raytorus::test
