// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <new>
#include <string>

#include "core/error.hpp"
#include "image/channels.hpp"
#include "image/png.hpp"
#include "image/srgb.hpp"

namespace raytorus::image {

namespace {

// Of the image, in the order of the file.
struct Channels {
    std::array<std::size_t, 4> index{};
    std::size_t count = 0;
};

Channels storedChannels(const Image& image, std::string_view name) {
    Channels channels;
    for (const std::string& channel : channelsOf({ChannelKind::Color, ChannelKind::Alpha})) {
        if (const int index = image.channelIndex(channel); index >= 0) {
            channels.index[channels.count++] = static_cast<std::size_t>(index);
        } else if (findQuantity(channel)->kind == ChannelKind::Color) {
            throw Error(
                ExitCode::File,
                fmt::format("cannot write \"{}\": a PNG needs the channels R, G and B, and the image has "
                            "no {}",
                            name, channel));
        }
    }
    return channels;
}

// The values of the file, rows from the top.
std::vector<std::uint8_t> storedValues(const Image& image, const Channels& channels, std::string_view name) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t stride = image.channelNames.size();
    const std::size_t pixels = image.pixels.size() / stride;
    std::vector<std::uint8_t> stored(pixels * channels.count);
    std::uint8_t* to = stored.data();
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (std::size_t i = 0; i < channels.count; ++i) {
            const float value = image.pixels[pixel * stride + channels.index[i]];
            if (!isFinite(value)) {
                throw Error(
                    ExitCode::NonFinite,
                    fmt::format("cannot write \"{}\": channel {} of pixel ({}, {}) is not a finite number",
                                name, image.channelNames[channels.index[i]], pixel % width, pixel / width));
            }
            *to++ = i == 3 ? encodeLinear(value) : encodeSrgb(value);
        }
    }
    return stored;
}

struct Output {
    std::vector<std::byte> bytes;
    std::string problem;
};

void append(png_struct* png, png_byte* data, std::size_t size) {
    auto& bytes = static_cast<Output*>(png_get_io_ptr(png))->bytes;
    const auto* from = reinterpret_cast<const std::byte*>(data);
    try {
        bytes.insert(bytes.end(), from, from + size);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");  // an exception must not pass through C
    }
}

[[noreturn]] void keepProblem(png_struct* png, const char* message) {
    static_cast<Output*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}

// The chunks are those that OpenImageIO writes, down to the offset of nothing. libpng leaves by longjmp, so
// nothing here may need a destructor. False: it left so.
bool writePng(png_struct* png, png_info* info, const Image& image, std::size_t channels,
              const std::uint8_t* stored) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    const auto width = static_cast<png_uint_32>(image.width);
    const auto height = static_cast<png_uint_32>(image.height);
    png_set_IHDR(png, info, width, height, 8, channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
    png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
    std::array key = std::to_array("oiio:ColorSpace");
    std::array value = std::to_array("sRGB");
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data();
    text.text = value.data();
    text.text_length = value.size() - 1;
    png_set_text(png, info, &text, 1);
    png_set_compression_level(png, 6);
    png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
    png_write_info(png, info);
    const std::size_t rowBytes = std::size_t{width} * channels;
    for (png_uint_32 row = 0; row < height; ++row) {
        png_write_row(png, stored + row * rowBytes);
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

std::vector<std::byte> encodePng(const Image& image, std::string_view name) {
    const Channels channels = storedChannels(image, name);
    const std::vector<std::uint8_t> stored = storedValues(image, channels, name);
    Output output;
    png_struct* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, keepProblem, nullptr);
    png_info* info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool written = false;
    if (info != nullptr) {
        png_set_write_fn(png, &output, append, nullptr);
        written = writePng(png, info, image, channels.count, stored.data());
    }
    png_destroy_write_struct(&png, &info);
    if (!written) {
        throw Error(ExitCode::File,
                    fmt::format("cannot write \"{}\": {}", name,
                                output.problem.empty() ? "libpng could not be set up" : output.problem));
    }
    return std::move(output.bytes);
}

}  // namespace raytorus::image
