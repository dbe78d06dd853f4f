// SPDX-License-Identifier: MIT
// The frame of a PNG file: a signature, then chunks of length, type, data and checksum.
#include "image/png_chunks.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace raytorus::image {

namespace {

constexpr std::size_t signatureSize = 8;
constexpr std::size_t frameSize = 12;  // length, type and checksum of a chunk

// CRC-32 of ISO 3309, a byte at a time (annex D of the PNG specification).
constexpr std::array<std::uint32_t, 256> crcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1u) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
        }
        table[byte] = crc;
    }
    return table;
}();

std::uint32_t crc32(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const std::byte byte : bytes) {
        crc = crcTable[(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xffu] ^ (crc >> 8);
    }
    return ~crc;
}

std::uint32_t bigEndian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.first(4)) {
        value = value << 8 | std::to_integer<std::uint32_t>(byte);
    }
    return value;
}

}  // namespace

std::string pngProblem(std::span<const std::byte> bytes) {
    for (std::size_t at = signatureSize; bytes.size() - at >= frameSize;) {
        const std::size_t length = bigEndian(bytes.subspan(at));
        if (length > bytes.size() - at - frameSize) {
            return fmt::format("it is truncated or corrupt (the chunk at byte {} does not end)", at);
        }
        const std::span<const std::byte> typeAndData = bytes.subspan(at + 4, length + 4);
        if (crc32(typeAndData) != bigEndian(bytes.subspan(at + 8 + length))) {
            return fmt::format("it is corrupt (the checksum of the chunk at byte {} is wrong)", at);
        }
        if (std::string_view(reinterpret_cast<const char*>(typeAndData.data()), 4) == "IEND") {
            return {};
        }
        at += frameSize + length;
    }
    return "it is truncated (its last chunk is missing)";
}

}  // namespace raytorus::image
