// SPDX-License-Identifier: MIT
// PNG files by libpng, read as they are stored.
#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <optional>

#include "image/channels.hpp"
#include "image/codec_checks.hpp"
#include "image/png.hpp"

namespace raytorus::image {

namespace {

// A PNG file is a signature, then chunks of length, type, data and checksum.
constexpr std::size_t signatureSize = 8;
constexpr std::size_t frameSize = 12;  // length, type and checksum of a chunk

std::uint32_t bigEndian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.first(4)) {
        value = value << 8 | std::to_integer<std::uint32_t>(byte);
    }
    return value;
}

// What is wrong with the chunks of a PNG file, as the end of a sentence, or nothing. Every chunk must be
// whole, have the right checksum, and the last must be IEND: libpng is content with a file that was cut after
// its last row, and reports the rest on stderr behind our back.
std::string pngProblem(std::span<const std::byte> bytes) {
    for (std::size_t at = signatureSize; bytes.size() - at >= frameSize;) {
        const std::size_t length = bigEndian(bytes.subspan(at));
        if (length > bytes.size() - at - frameSize) {
            return fmt::format("it is truncated or corrupt (the chunk at byte {} does not end)", at);
        }
        const std::span<const std::byte> typeAndData = bytes.subspan(at + 4, length + 4);
        const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(typeAndData.data()), typeAndData.size());
        if (sum != bigEndian(bytes.subspan(at + 8 + length))) {
            return fmt::format("it is corrupt (the checksum of the chunk at byte {} is wrong)", at);
        }
        if (std::string_view(reinterpret_cast<const char*>(typeAndData.data()), 4) == "IEND") {
            return {};
        }
        at += frameSize + length;
    }
    return "it is truncated (its last chunk is missing)";
}

struct PngInput {
    std::span<const std::byte> bytes;  // not yet read
    std::string problem;
};

// What is outside of setjmp's reach.
struct Stored {
    int width = 0, height = 0;
    int depth = 8;  // bits of a value, 8 or 16
    std::size_t channels = 0;
    std::size_t rowBytes = 0;
    std::string problem;
    std::optional<ImageFill> fill;
    std::vector<std::uint8_t> rows;  // one, or all where they come in several passes
    std::vector<png_byte*> starts;
    std::vector<float> values;  // of one row
};

void readInput(png_struct* png, png_byte* to, std::size_t size) {
    auto& bytes = static_cast<PngInput*>(png_get_io_ptr(png))->bytes;
    if (size > bytes.size()) {
        png_error(png, "it ends too early");
    }
    std::memcpy(to, bytes.data(), size);
    bytes = bytes.subspan(size);
}

[[noreturn]] void keepReason(png_struct* png, const char* message) {
    static_cast<PngInput*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}

void passOverWarning(png_struct* /*png*/, const char* /*warning*/) {}

std::vector<std::string> namesOf(std::size_t channels) {
    std::vector<std::string> names{"Y"};
    if (channels > 2) {
        names = channelsOf({ChannelKind::Color});
    }
    if (channels % 2 == 0) {
        names.push_back(channelsOf({ChannelKind::Alpha}).front());
    }
    return names;
}

// Deflate makes at most 258 bytes of two bits.
constexpr std::size_t mostOfOneByte = 1032;

void takeHeader(Stored& stored, const png_struct* png, const png_info* info, std::size_t compressed) {
    stored.width = static_cast<int>(std::min<png_uint_32>(png_get_image_width(png, info), INT32_MAX));
    stored.height = static_cast<int>(std::min<png_uint_32>(png_get_image_height(png, info), INT32_MAX));
    const std::size_t bits = std::size_t{png_get_bit_depth(png, info)} * png_get_channels(png, info);
    stored.problem = shapeProblem(stored.width, stored.height, namesOf(1));
    const auto pixels = static_cast<std::size_t>(stored.width) * static_cast<std::size_t>(stored.height);
    if (stored.problem.empty() && pixels * bits / 8 > compressed * mostOfOneByte) {
        stored.problem = fmt::format("it is truncated or corrupt ({} bytes cannot hold {} x {} pixels)",
                                     compressed, stored.width, stored.height);
    }
}

void takeShape(Stored& stored, const png_struct* png, const png_info* info) {
    stored.depth = png_get_bit_depth(png, info);
    stored.channels = png_get_channels(png, info);
    stored.rowBytes = png_get_rowbytes(png, info);
    const std::vector<std::string> names = namesOf(stored.channels);
    stored.problem = shapeProblem(stored.width, stored.height, names);
    if (stored.problem.empty()) {
        stored.fill.emplace(stored.width, stored.height, names,
                            stored.depth == 16 ? SampleType::Unsigned16 : SampleType::Unsigned8);
    }
}

void makeRows(Stored& stored, std::size_t count) {
    stored.rows.resize(stored.rowBytes * count);
    for (std::size_t y = 0; y < count; ++y) {
        stored.starts.push_back(stored.rows.data() + y * stored.rowBytes);
    }
    stored.values.resize(static_cast<std::size_t>(stored.width) * stored.channels);
}

void appendRow(Stored& stored, const std::uint8_t* row) {
    for (std::size_t i = 0; i < stored.values.size(); ++i) {
        if (stored.depth == 16) {
            std::uint16_t value = 0;
            std::memcpy(&value, row + i * sizeof value, sizeof value);
            stored.values[i] = static_cast<float>(value) / 65535.0f;
        } else {
            stored.values[i] = static_cast<float>(row[i]) / 255.0f;
        }
    }
    stored.fill->append(stored.values);
}

// libpng leaves by longjmp: nothing here may need a destructor. False: it left so, or there is a problem.
bool readPng(png_struct* png, png_info* info, Stored& stored, std::size_t compressed, bool headerAlone) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_info(png, info);
    takeHeader(stored, png, info, compressed);
    if (!stored.problem.empty()) {
        return false;
    }
    png_set_expand(png);  // palettes, few bits, transparent colours
    if (png_get_bit_depth(png, info) == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    const bool inPasses = png_set_interlace_handling(png) > 1;
    png_read_update_info(png, info);
    takeShape(stored, png, info);
    if (!stored.problem.empty() || headerAlone) {
        return stored.problem.empty();
    }
    makeRows(stored, inPasses ? static_cast<std::size_t>(stored.height) : 1);
    if (inPasses) {
        png_read_image(png, stored.starts.data());
    }
    for (int y = 0; y < stored.height; ++y) {
        if (!inPasses) {
            png_read_row(png, stored.starts[0], nullptr);
        }
        appendRow(stored, stored.starts[inPasses ? static_cast<std::size_t>(y) : 0]);
    }
    png_read_end(png, nullptr);
    return true;
}

struct PngReader {
    PngReader() = default;
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    png_struct* png = nullptr;
    png_info* info = nullptr;
};

Image decodeFrom(std::span<const std::byte> bytes, std::string_view name, bool headerAlone) {
    checkSignature(bytes, Format::Png, name);
    if (const std::string problem = pngProblem(bytes); !problem.empty()) {
        failReading(name, problem);
    }
    PngInput input{bytes, ""};
    Stored stored;
    PngReader reader;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, keepReason, passOverWarning);
    reader.info = reader.png != nullptr ? png_create_info_struct(reader.png) : nullptr;
    bool whole = false;
    if (reader.info != nullptr) {
        png_set_read_fn(reader.png, &input, readInput);
        whole = readPng(reader.png, reader.info, stored, bytes.size(), headerAlone);
    }
    if (!stored.problem.empty()) {
        failReading(name, stored.problem);
    }
    if (!whole) {
        failReading(name, fmt::format("it is truncated or corrupt ({})", oneLine(input.problem)));
    }
    return stored.fill->take();
}

}  // namespace

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
    return decodeFrom(bytes, name, false);
}

Image decodePngHeader(std::span<const std::byte> bytes, std::string_view name) {
    return decodeFrom(bytes, name, true);
}

}  // namespace raytorus::image
