// SPDX-License-Identifier: MIT
// PNG files by libpng, read as they are stored.
#include "image/png_decode.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstring>

#include "image/codec_checks.hpp"
#include "image/png_chunks.hpp"

namespace raytorus::image {

namespace {

struct PngInput {
    std::span<const std::byte> bytes;  // not yet read
    std::string problem;
};

// What is outside of setjmp's reach.
struct Stored {
    png_uint_32 width = 0, height = 0;
    int depth = 8;  // bits of a value, 8 or 16
    std::size_t channels = 0;
    std::string shapeProblem;
    std::vector<std::uint8_t> values;
    std::vector<png_byte*> rows;
};

void read(png_struct* png, png_byte* to, std::size_t size) {
    auto& bytes = static_cast<PngInput*>(png_get_io_ptr(png))->bytes;
    if (size > bytes.size()) {
        png_error(png, "it ends too early");
    }
    std::memcpy(to, bytes.data(), size);
    bytes = bytes.subspan(size);
}

[[noreturn]] void keepProblem(png_struct* png, const char* message) {
    static_cast<PngInput*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}

void passOver(png_struct* /*png*/, const char* /*warning*/) {}

std::vector<std::string> namesOf(std::size_t channels) {
    const std::array<std::vector<std::string>, 4> names = {
        {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}};
    return names[channels - 1];
}

bool prepare(Stored& stored, std::size_t rowBytes) {
    stored.shapeProblem = shapeProblem(static_cast<int>(std::min<png_uint_32>(stored.width, INT32_MAX)),
                                       static_cast<int>(std::min<png_uint_32>(stored.height, INT32_MAX)),
                                       namesOf(stored.channels));
    if (!stored.shapeProblem.empty()) {
        return false;
    }
    stored.values.resize(rowBytes * stored.height);
    for (png_uint_32 y = 0; y < stored.height; ++y) {
        stored.rows.push_back(stored.values.data() + y * rowBytes);
    }
    return true;
}

// libpng leaves by longjmp: nothing here may need a destructor. False: it left so, or the shape is none.
bool readPng(png_struct* png, png_info* info, Stored& stored) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_info(png, info);
    png_set_expand(png);  // palettes, few bits, transparent colours
    if (png_get_bit_depth(png, info) == 16 && std::endian::native == std::endian::little) {
        png_set_swap(png);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    stored.width = png_get_image_width(png, info);
    stored.height = png_get_image_height(png, info);
    stored.depth = png_get_bit_depth(png, info);
    stored.channels = png_get_channels(png, info);
    if (!prepare(stored, png_get_rowbytes(png, info))) {
        return false;
    }
    png_read_image(png, stored.rows.data());
    png_read_end(png, nullptr);
    return true;
}

std::vector<float> valuesOf(const Stored& stored) {
    std::vector<float> values(stored.values.size() / (stored.depth == 16 ? 2 : 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (stored.depth == 16) {
            std::uint16_t value = 0;
            std::memcpy(&value, &stored.values[i * sizeof value], sizeof value);
            values[i] = static_cast<float>(value) / 65535.0f;
        } else {
            values[i] = static_cast<float>(stored.values[i]) / 255.0f;
        }
    }
    return values;
}

}  // namespace

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
    checkSignature(bytes, Format::Png, name);
    if (const std::string problem = pngProblem(bytes); !problem.empty()) {
        failReading(name, problem);
    }
    PngInput input{bytes, ""};
    Stored stored;
    png_struct* png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, keepProblem, passOver);
    png_info* info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool whole = false;
    if (info != nullptr) {
        png_set_read_fn(png, &input, read);
        whole = readPng(png, info, stored);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    if (!stored.shapeProblem.empty()) {
        failReading(name, stored.shapeProblem);
    }
    if (!whole) {
        failReading(name, fmt::format("it is truncated or corrupt ({})", input.problem));
    }
    Image image = arrangedImage(static_cast<int>(stored.width), static_cast<int>(stored.height),
                                namesOf(stored.channels), valuesOf(stored));
    image.sampleType = stored.depth == 16 ? SampleType::Unsigned16 : SampleType::Unsigned8;
    return image;
}

}  // namespace raytorus::image
