// SPDX-License-Identifier: MIT
// Sizes that a header promises: read before the pixels, held to limits, and no more memory taken for them
// than there are pixels in the file.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>

#include "compare/compare.hpp"
#include "core/file.hpp"
#include "image/codec_module.hpp"
#include "image/image_codec.hpp"
#include "image/image_io.hpp"
#include "support/expect_error.hpp"
#include "support/png_damage.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::image {
namespace {

using test::expectError;
using test::scratchFolder;

// A black PNG of any size, row by row: deflate makes a thousandth of it.
void writeBlackPng(const std::filesystem::path& path, png_uint_32 width, png_uint_32 height, int colour,
                   int interlace = PNG_INTERLACE_NONE) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    png_struct* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_info* info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_compression_level(png, 6);
    png_set_IHDR(png, info, width, height, 8, colour, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    std::vector<png_byte> row(std::size_t{4} * width);
    for (int pass = png_set_interlace_handling(png); pass > 0; --pass) {
        for (png_uint_32 y = 0; y < height; ++y) {
            png_write_row(png, row.data());
        }
    }
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

// An EXR whose header promises another size than it has.
std::vector<std::byte> promising(std::vector<std::byte> exr, std::int32_t width, std::int32_t height) {
    const std::string_view text(reinterpret_cast<const char*>(exr.data()), exr.size());
    for (const std::string_view window : {"dataWindow", "displayWindow"}) {
        // After the name come the type "box2i", the size, and then xMin yMin xMax yMax.
        const std::size_t at = text.find(window) + window.size() + 7 + 4;
        const std::int32_t last[] = {width - 1, height - 1};
        std::memcpy(exr.data() + at + 8, last, sizeof last);
    }
    return exr;
}

long statusMebibytes(const std::string& key) {
    const std::string status = test::fileText("/proc/self/status");
    return std::stol(status.substr(status.find(key) + key.size())) / 1024;
}

// What the work takes of memory at most, more than there was, in MiB.
template <typename Work>
long peakOf(Work work) {
    test::writeText("/proc/self/clear_refs", "5");  // the highest so far is forgotten
    const long before = statusMebibytes("VmRSS:");
    work();
    return statusMebibytes("VmHWM:") - before;
}

constexpr long fewMebibytes = 120;

std::string problemOf(std::span<const std::byte> bytes, Format format, bool headerAlone) {
    try {
        static_cast<void>(headerAlone ? decodeHeader(bytes, format, "x") : decode(bytes, format, "x"));
    } catch (const Error& error) {
        EXPECT_EQ(error.exitCode, ExitCode::File);
        return error.what();
    }
    return "";
}

TEST(ImageSizes, HeadersAreThoseOfTheImages) {
    const auto folder = scratchFolder();
    const Image image(7, 5, {"R", "G", "B", "A"});
    for (const char* name : {"a.png", "a.exr"}) {
        writeImage(folder / name, image);
        const ImageFile file(folder / name);
        EXPECT_EQ(file.header().width, 7);
        EXPECT_EQ(file.header().height, 5);
        EXPECT_EQ(file.header().channelNames, image.channelNames);
        EXPECT_EQ(file.header().sampleType, file.read().sampleType);
        EXPECT_TRUE(file.header().pixels.empty());
        EXPECT_EQ(file.read().pixels.size(), image.pixels.size());
    }
    writeBlackPng(folder / "grey.png", 3, 2, PNG_COLOR_TYPE_GRAY);
    EXPECT_EQ(ImageFile(folder / "grey.png").header().channelNames, std::vector<std::string>{"Y"});
}

TEST(ImageSizes, ShapesAreComparedWithoutPixels) {
    Image one;
    one.width = 16384;
    one.height = 16384;
    one.channelNames = {"R", "G", "B"};
    Image other = one;
    EXPECT_FALSE(compare::compareShapes(one, other, {}).has_value());
    other.width = 16;
    const auto comparison = compare::compareShapes(one, other, {});
    ASSERT_TRUE(comparison.has_value());
    EXPECT_EQ(comparison->exitCode(), ExitCode::SizeDiffers);
    EXPECT_EQ(comparison->sentence, compare::compare(one, other, {}).sentence);
}

TEST(ImageSizes, AHugePictureOfAnotherSizeIsNotDecoded) {
    const auto folder = scratchFolder();
    writeBlackPng(folder / "huge.png", 16384, 16384, PNG_COLOR_TYPE_GRAY);
    EXPECT_LT(std::filesystem::file_size(folder / "huge.png"), 1'000'000U);
    EXPECT_LT(peakOf([&] { EXPECT_EQ(ImageFile(folder / "huge.png").header().width, 16384); }), fewMebibytes);
}

TEST(ImageSizes, OverTheLimitIsRefusedBeforeMemoryIsTaken) {
    const auto path = scratchFolder() / "small.png";
    writeBlackPng(path, 4, 4, PNG_COLOR_TYPE_RGBA);
    const std::string png = test::fileText(path);
    const std::vector<std::byte> exr = encode(Image(4, 4, {"R", "G", "B"}), Format::Exr, "small");
    std::string missing;
    const Codec* const plain = loadCodec(openExrModule, missing);
    ASSERT_NE(plain, nullptr) << missing;
    for (const bool headerAlone : {false, true}) {
        for (const auto& [width, height, words] : {std::tuple(0x7fffffffU, 1U, "over 65536 pixels a side"),
                                                   std::tuple(65536U, 65536U, "over 1073741824 values"),
                                                   std::tuple(1U, 65537U, "over 65536 pixels a side")}) {
            const std::string problem =
                problemOf(bytesOf(test::promising(png, width, height)), Format::Png, headerAlone);
            EXPECT_TRUE(problem.find(words) != std::string::npos ||
                        (width > 1'000'000U && problem.find("truncated or corrupt") != std::string::npos))
                << problem;
            const auto bytes = promising(exr, static_cast<int>(width), static_cast<int>(height));
            EXPECT_NE(problemOf(bytes, Format::Exr, headerAlone), "");
            expectError(
                [&] { static_cast<void>((headerAlone ? plain->decodeHeader : plain->decode)(bytes, "x")); },
                ExitCode::File, {words});
        }
    }
}

// Within the limits, and still gigabytes that the file has not.
TEST(ImageSizes, WhatAHeaderPromisesTakesNoMemory) {
    const auto folder = scratchFolder();
    const std::vector<std::byte> exr = encode(Image(64, 64, {"R", "G", "B"}), Format::Exr, "small");
    std::string openExr;
    const Codec* const plain = loadCodec(openExrModule, openExr);
    ASSERT_NE(plain, nullptr) << openExr;
    static_cast<void>(decode(exr, Format::Exr, "small"));  // the module is there before memory is measured
    for (const std::int32_t side : {16384, 18000}) {
        const std::vector<std::byte> bytes = promising(exr, side, side);
        EXPECT_NE(problemOf(bytes, Format::Exr, false), "");
        EXPECT_LT(peakOf([&] { static_cast<void>(problemOf(bytes, Format::Exr, false)); }), fewMebibytes);
        EXPECT_LT(peakOf([&] { EXPECT_THROW(static_cast<void>(plain->decode(bytes, "x")), Error); }),
                  fewMebibytes);
    }
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
        writeBlackPng(folder / "small.png", 64, 64, PNG_COLOR_TYPE_RGBA, interlace);
        const std::string png = test::promising(test::fileText(folder / "small.png"), 16384, 16384);
        EXPECT_NE(problemOf(bytesOf(png), Format::Png, false).find("cannot hold 16384 x 16384 pixels"),
                  std::string::npos);
        EXPECT_LT(peakOf([&] { static_cast<void>(problemOf(bytesOf(png), Format::Png, false)); }),
                  fewMebibytes);
    }
}

TEST(ImageSizes, AnImageTakesLittleMoreThanItsPixels) {
    const auto folder = scratchFolder();
    writeBlackPng(folder / "a.png", 4096, 4096, PNG_COLOR_TYPE_RGB);
    writeImage(folder / "a.exr", Image(4096, 4096, {"R", "G", "B"}));
    static_cast<void>(ImageFile(folder / "a.exr"));
    for (const char* name : {"a.png", "a.exr"}) {
        constexpr long pixels = 4096L * 4096 * 3 * 4 / (1 << 20);
        EXPECT_LT(peakOf([&] { static_cast<void>(readImage(folder / name)); }), pixels + fewMebibytes)
            << name;
    }
}

// libpng's own line stood on standard error, besides ours.
TEST(ImageSizes, ADamagedPngIsOneSentence) {
    const auto path = scratchFolder() / "a.png";
    writeBlackPng(path, 64, 64, PNG_COLOR_TYPE_RGB);
    const std::string png = test::withDamagedData(test::fileText(path));
    testing::internal::CaptureStderr();
    const std::string problem = problemOf(bytesOf(png), Format::Png, false);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(problem.starts_with("cannot read \"x\": it is truncated or corrupt (")) << problem;
    EXPECT_GT(problem.size(), std::string("cannot read \"x\": it is truncated or corrupt ()").size());
}

// Interlaced pictures come in passes: the same pixels.
TEST(ImageSizes, InterlacedPngs) {
    const auto folder = scratchFolder();
    writeBlackPng(folder / "plain.png", 37, 21, PNG_COLOR_TYPE_RGB);
    writeBlackPng(folder / "passes.png", 37, 21, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7);
    EXPECT_EQ(readImage(folder / "plain.png").pixels, readImage(folder / "passes.png").pixels);
}

TEST(ImageSizes, AModuleThatIsMissingSaysWhy) {
    std::string problem;
    EXPECT_EQ(loadCodec("raytorus-nothing.so", problem), nullptr);
    EXPECT_NE(problem.find("raytorus-nothing.so"), std::string::npos) << problem;
    EXPECT_NE(problem.find("No such file"), std::string::npos) << problem;
    const auto path = scratchFolder() / "damaged.so";
    test::writeText(path, "no library");
    EXPECT_EQ(loadCodec(path.c_str(), problem), nullptr);
    EXPECT_NE(problem.find("damaged.so"), std::string::npos) << problem;
    EXPECT_EQ(loadCodec("libm.so.6", problem), nullptr);
    EXPECT_NE(problem.find("raytorusCodec"), std::string::npos) << problem;
}

}  // namespace
}  // namespace raytorus::image
