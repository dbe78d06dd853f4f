// SPDX-License-Identifier: MIT
#include "support/png_damage.hpp"

#include <cstddef>

namespace raytorus::test {
namespace {

std::uint32_t bigEndian(const std::string& text, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
        value = value << 8U | static_cast<unsigned char>(text[i]);
    }
    return value;
}

void putBigEndian(std::string& text, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        text[at + i] = static_cast<char>(value >> (24U - 8U * i));
    }
}

// Puts right the checksum of the chunk whose type stands at this place: CRC-32 of its type and data.
void putChecksum(std::string& png, std::size_t type) {
    const std::size_t end = type + 4 + bigEndian(png, type - 4);
    std::uint32_t crc = 0xffffffffU;
    for (std::size_t i = type; i < end; ++i) {
        crc ^= static_cast<unsigned char>(png[i]);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? 0xedb88320U ^ crc >> 1U : crc >> 1U;
        }
    }
    putBigEndian(png, end, ~crc);
}

}  // namespace

std::string promising(std::string png, std::uint32_t width, std::uint32_t height) {
    const std::size_t header = png.find("IHDR");
    putBigEndian(png, header + 4, width);
    putBigEndian(png, header + 8, height);
    putChecksum(png, header);
    return png;
}

std::string withDamagedData(std::string png) {
    constexpr std::size_t someByte = 20;
    const std::size_t data = png.find("IDAT");
    png[data + someByte] = static_cast<char>(png[data + someByte] ^ 0x55);
    putChecksum(png, data);
    return png;
}

}  // namespace raytorus::test
