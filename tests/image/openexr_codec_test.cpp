// SPDX-License-Identifier: MIT
// Image files read and written by OpenEXR and libpng, held to OpenImageIO: the same image of each file, the
// same bytes.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <stdexcept>

#include "core/file.hpp"
#include "image/codec_module.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::image {
namespace {

using test::expectError;
using test::scratchFolder;

// By the module that serves where OpenImageIO's is not.
namespace plain {

const Codec& codec() {
    static std::string problem;
    static const Codec* const loaded = loadCodec(openExrModule, problem);
    if (loaded == nullptr) {
        throw std::runtime_error(problem);
    }
    return *loaded;
}

Image decodeExr(std::span<const std::byte> bytes, std::string_view name) {
    const Image image = codec().decode(bytes, name);
    const Image header = codec().decodeHeader(bytes, name);
    EXPECT_EQ(header.width, image.width);
    EXPECT_EQ(header.height, image.height);
    EXPECT_EQ(header.channelNames, image.channelNames);
    EXPECT_EQ(header.sampleType, image.sampleType);
    EXPECT_TRUE(header.pixels.empty());
    return image;
}

std::vector<std::byte> encodeExr(const Image& image, std::string_view name) {
    return codec().encode(image, name);
}

}  // namespace plain

std::vector<std::uint32_t> valueBits(const Image& image) {
    std::vector<std::uint32_t> bits(image.pixels.size());
    std::memcpy(bits.data(), image.pixels.data(), bits.size() * sizeof(float));
    return bits;
}

void expectSame(const Image& plain, const Image& image) {
    EXPECT_EQ(plain.width, image.width);
    EXPECT_EQ(plain.height, image.height);
    EXPECT_EQ(plain.channelNames, image.channelNames);
    EXPECT_EQ(plain.sampleType, image.sampleType);
    EXPECT_EQ(valueBits(plain), valueBits(image));
}

// Values with all exponents and both signs, of which zip makes little or nothing.
Image anImage(int width, int height, std::vector<std::string> names, bool noise) {
    Image image(width, height, std::move(names));
    std::uint32_t state = 2024;
    for (float& value : image.pixels) {
        state = state * 1664525u + 1013904223u;
        value = noise ? std::bit_cast<float>(state) : static_cast<float>(state >> 28) / 8.0f;
    }
    return image;
}

TEST(OpenExrCodec, GoldensAreReadAsByOpenImageIo) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RAYTORUS_SOURCE_DIR "/golden")) {
        if (entry.path().extension() == ".exr") {
            SCOPED_TRACE(entry.path());
            const std::vector<std::byte> bytes = readFile(entry.path());
            const Image image = decode(bytes, Format::Exr, "golden");
            expectSame(plain::decodeExr(bytes, "golden"), image);
            EXPECT_EQ(plain::encodeExr(image, "golden"), bytes);
            ++files;
        }
    }
    EXPECT_GE(files, 60);
}

TEST(OpenExrCodec, ExrOfAnyShapeIsTheSameBothWays) {
    const std::string longName(40, 'n');
    for (const bool noise : {false, true}) {
        for (const auto& [width, height] : {std::pair(1, 1), {1, 16}, {3, 17}, {64, 33}, {200, 5}}) {
            for (const std::vector<std::string>& names : {std::vector<std::string>{"Y"},
                                                          {"R", "G", "B", "A"},
                                                          {"b", "a", "B", "AA", "a.b", longName}}) {
                const Image image = anImage(width, height, names, noise);
                const std::vector<std::byte> bytes = encode(image, Format::Exr, "image");
                EXPECT_EQ(plain::encodeExr(image, "image"), bytes) << width << " x " << height;
                expectSame(plain::decodeExr(bytes, "image"), decode(bytes, Format::Exr, "image"));
            }
        }
    }
}

// The bytes of a file that OpenImageIO writes.
std::vector<std::byte> written(const char* format, OIIO::ImageSpec spec, OIIO::TypeDesc type,
                               const void* values, const std::filesystem::path& path) {
    const auto output = OIIO::ImageOutput::create(format);
    spec.attribute("DateTime", "");
    EXPECT_TRUE(output->open(path.string(), spec)) << output->geterror();
    EXPECT_TRUE(output->write_image(type, values)) << output->geterror();
    EXPECT_TRUE(output->close());
    return readFile(path);
}

TEST(OpenExrCodec, ExrOfOtherProgramsIsReadOrRefusedInASentence) {
    const auto path = scratchFolder() / "a.exr";
    const Image image = anImage(21, 19, {"R", "G", "B"}, false);
    OIIO::ImageSpec spec(21, 19, 3, OIIO::TypeDesc::FLOAT);
    const auto bytesOf = [&] {
        return written("openexr", spec, OIIO::TypeDesc::FLOAT, image.pixels.data(), path);
    };
    for (const auto& type : {OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::HALF}) {
        spec.set_format(type);
        for (const int tile : {0, 16, 64}) {
            spec.tile_width = spec.tile_height = tile;
            for (const char* compression : {"none", "zip", "zips", "rle", "piz", "pxr24", "b44", "dwaa"}) {
                SCOPED_TRACE(std::string(compression) + ", tiles of " + std::to_string(tile));
                spec.attribute("compression", compression);
                const std::vector<std::byte> bytes = bytesOf();
                expectSame(plain::decodeExr(bytes, "a"), decode(bytes, Format::Exr, "a"));
            }
        }
    }
    spec.tile_width = spec.tile_height = 0;
    spec.attribute("compression", "zip");
    spec.set_format(OIIO::TypeDesc::UINT);
    expectError([&] { std::ignore = plain::decodeExr(bytesOf(), "a"); }, ExitCode::File,
                {"channel B holds integers"});
    spec.set_format(OIIO::TypeDesc::FLOAT);
    spec.full_width = 30;
    expectError([&] { std::ignore = plain::decodeExr(bytesOf(), "a"); }, ExitCode::File, {"display window"});
}

// The place after the first occurrence of a name and a type, each with its 0, and of the value's size.
std::size_t valuePlace(const std::vector<std::byte>& bytes, std::string_view nameAndType) {
    const auto text = std::as_bytes(std::span(nameAndType));
    const auto found = std::ranges::search(bytes, text);
    EXPECT_FALSE(found.empty()) << nameAndType;
    return static_cast<std::size_t>(found.end() - bytes.begin()) + sizeof(std::uint32_t);
}

void put(std::vector<std::byte>& bytes, std::size_t place, std::int32_t value) {
    std::memcpy(&bytes.at(place), &value, sizeof value);
}

TEST(OpenExrCodec, WhatAFileClaimsTakesNoRoomBeforeItIsJudged) {
    using namespace std::string_view_literals;
    OIIO::ImageSpec spec(5, 4, 1, OIIO::TypeDesc::FLOAT);
    const std::vector<float> values(20, 0.5f);
    const auto path = scratchFolder() / "claims.exr";
    const auto bytesOf = [&] { return written("openexr", spec, OIIO::TypeDesc::FLOAT, values.data(), path); };
    const auto expectRefused = [](const std::vector<std::byte>& bytes, const std::string& part) {
        expectError([&] { std::ignore = plain::decodeExr(bytes, "a"); }, ExitCode::File, {part});
    };
    const std::vector<std::byte> whole = bytesOf();
    auto bytes = whole;
    put(bytes, valuePlace(bytes, "dataWindow\0box2i\0"sv) + 8, 1 << 30);
    expectRefused(bytes, "over 65536 pixels a side");
    bytes = whole;
    put(bytes, valuePlace(bytes, "dataWindow\0box2i\0"sv) + 12, INT32_MAX);
    expectRefused(bytes, "over 65536 pixels a side");
    bytes = whole;
    put(bytes, valuePlace(bytes, "capDate\0string\0"sv) - 4, INT32_MAX);
    expectRefused(bytes, "it is truncated or corrupt (it ends too early)");
    bytes = whole;
    put(bytes, 4, 2 | 0x800);
    expectRefused(bytes, "deep");
    put(bytes, 4, 2 | 0x1000);
    expectRefused(bytes, "several parts");
    spec.tile_width = spec.tile_height = 16;
    bytes = bytesOf();
    put(bytes, valuePlace(bytes, "tiles\0tiledesc\0"sv), INT32_MAX);
    expectRefused(bytes, "its tiles of 2147483647 x 16 are none");
}

TEST(OpenExrCodec, EveryHalfIsTheFloatThatItIs) {
    std::vector<std::uint16_t> halves(65536);
    std::iota(halves.begin(), halves.end(), std::uint16_t{0});
    const OIIO::ImageSpec spec(256, 256, 1, OIIO::TypeDesc::HALF);
    const std::vector<std::byte> bytes =
        written("openexr", spec, OIIO::TypeDesc::HALF, halves.data(), scratchFolder() / "half.exr");
    expectSame(plain::decodeExr(bytes, "half"), decode(bytes, Format::Exr, "half"));
}

Image byOpenImageIo(const std::filesystem::path& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &config);
    const OIIO::ImageSpec& spec = input->spec();
    Image image(spec.width, spec.height, spec.channelnames);
    const bool greyWithAlpha = spec.nchannels == 2;  // Y, A there; A goes first here
    const bool wide = spec.format == OIIO::TypeDesc::UINT16;
    image.sampleType = wide ? SampleType::Unsigned16 : SampleType::Unsigned8;
    std::vector<std::uint16_t> stored(image.pixels.size());
    std::vector<std::uint8_t> narrow(image.pixels.size());
    EXPECT_TRUE(wide ? input->read_image(0, 0, 0, spec.nchannels, spec.format, stored.data())
                     : input->read_image(0, 0, 0, spec.nchannels, spec.format, narrow.data()));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[greyWithAlpha ? i ^ 1U : i] =
            wide ? static_cast<float>(stored[i]) / 65535.0f : static_cast<float>(narrow[i]) / 255.0f;
    }
    if (greyWithAlpha) {
        std::swap(image.channelNames[0], image.channelNames[1]);
    }
    return image;
}

TEST(OpenExrCodec, PngOfEveryKindIsReadAsByOpenImageIo) {
    const auto path = scratchFolder() / "a.png";
    std::vector<std::uint16_t> values(13 * 7 * 4);
    std::iota(values.begin(), values.end(), std::uint16_t{60000});
    for (int channels = 1; channels <= 4; ++channels) {
        for (const auto& type : {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16}) {
            OIIO::ImageSpec spec(13, 7, channels, type);
            spec.attribute("oiio:UnassociatedAlpha", 1);
            const std::vector<std::byte> bytes =
                written("png", spec, OIIO::TypeDesc::UINT16, values.data(), path);
            expectSame(decode(bytes, Format::Png, "a"), byOpenImageIo(path));
        }
    }
}

template <typename Decode>
void expectDamageSeen(const std::vector<std::byte>& bytes, Decode decodePlainly) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        SCOPED_TRACE("cut to " + std::to_string(size) + " of " + std::to_string(bytes.size()));
        expectError([&] { std::ignore = decodePlainly(std::span(bytes).first(size), "cut"); }, ExitCode::File,
                    {"cannot read \"cut\": "});
    }
    std::size_t refused = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (const std::byte flip : {std::byte{0x01}, std::byte{0x80}, std::byte{0xff}}) {
            std::vector<std::byte> damaged = bytes;
            damaged[at] ^= flip;
            try {
                std::ignore = decodePlainly(damaged, "damaged");
            } catch (const Error& error) {
                EXPECT_EQ(error.exitCode, ExitCode::File) << error.what();
                ++refused;
            }
        }
    }
    EXPECT_GE(refused, 3 * bytes.size() / 2);
}

TEST(OpenExrCodec, DamageNeverDoesMoreThanFail) {
    const Image image = anImage(1, 40, {"R", "G", "B", "A"}, false);
    expectDamageSeen(encode(image, Format::Exr, "whole"), plain::decodeExr);
    expectDamageSeen(encode(image, Format::Png, "whole"),
                     [](auto bytes, const char* name) { return decode(bytes, Format::Png, name); });
}

}  // namespace
}  // namespace raytorus::image
