// SPDX-License-Identifier: MIT
// Image files: what is written comes back, in a known order, and the same image gives the same file.
#include "image/image_io.hpp"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "image/image_codec.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::image {
namespace {

using test::expectError;
using test::fileText;
using test::scratchFolder;

std::vector<std::uint32_t> bitsOf(const Image& image) {
    std::vector<std::uint32_t> bits(image.pixels.size());
    std::memcpy(bits.data(), image.pixels.data(), bits.size() * sizeof(float));
    return bits;
}

// The attributes in the header of an EXR file, as "name=value bytes".
std::vector<std::string> exrAttributes(const std::string& file) {
    std::vector<std::string> attributes;
    std::size_t at = 8;  // after the magic number and the version
    while (at < file.size() && file[at] != '\0') {
        const std::string name = file.c_str() + at;
        const std::string type = file.c_str() + at + name.size() + 1;
        at += name.size() + type.size() + 2;
        std::uint32_t size = 0;
        std::memcpy(&size, file.data() + at, sizeof size);
        attributes.push_back(name + "=" + file.substr(at + sizeof size, size));
        at += sizeof size + size;
    }
    return attributes;
}

TEST(ImageIo, ExrKeepsAllBits) {
    // Every sign and exponent with a choice of mantissas: zeros, denormals, numbers, infinities, NaN.
    std::vector<float> values;
    for (std::uint32_t upper = 0; upper < 512; ++upper) {
        for (const std::uint32_t mantissa :
             {0x000000u, 0x000001u, 0x2aaaaau, 0x400000u, 0x555555u, 0x7fffffu}) {
            values.push_back(std::bit_cast<float>(upper << 23 | mantissa));
        }
    }
    std::mt19937 random(20240607);
    while (values.size() < 64 * 64 * 2) {
        values.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    }
    Image image(64, 64, {"R", "depth"});
    image.pixels = values;
    const auto path = scratchFolder() / "bits.exr";
    writeImage(path, image);
    const Image back = readImage(path);
    EXPECT_EQ(back.width, 64);
    EXPECT_EQ(back.height, 64);
    EXPECT_EQ(back.channelNames, image.channelNames);
    EXPECT_EQ(bitsOf(back), bitsOf(image));
}

TEST(ImageIo, ExrChannelsComeInTheDocumentedOrderWithTheirOwnValues) {
    const std::vector<std::string> written = {"uv.v",     "Z", "B",  "normal.z", "A",
                                              "normal.x", "G", "id", "uv.u",     "R"};
    const std::vector<std::string> expected = {"R",  "G",        "B",        "A",    "Z",
                                               "id", "normal.x", "normal.z", "uv.u", "uv.v"};
    Image image(5, 3, written);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = static_cast<float>(i);
    }
    const auto path = scratchFolder() / "order.exr";
    writeImage(path, image);
    const Image back = readImage(path);
    ASSERT_EQ(back.channelNames, expected);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            for (const std::string& name : written) {
                EXPECT_EQ(back.at(x, y, name), image.at(x, y, name)) << name << " at " << x << ", " << y;
            }
        }
    }
}

TEST(ImageIo, ChannelsWithoutColourAreSortedByTheBytesOfTheirNames) {
    Image image(2, 1, {"b", "a", "B", "AA", "a.b"});
    image.pixels = {0, 1, 2, 3, 4, 10, 11, 12, 13, 14};
    const auto path = scratchFolder() / "order.exr";
    writeImage(path, image);
    const Image back = readImage(path);
    EXPECT_EQ(back.channelNames, (std::vector<std::string>{"B", "AA", "a", "a.b", "b"}));
    EXPECT_EQ(back.pixels, (std::vector<float>{2, 3, 1, 4, 0, 12, 13, 11, 14, 10}));
}

TEST(ImageIo, ExrHoldsNoDateHostOrProgramAndIsZipped) {
    const auto folder = scratchFolder();
    const Image image(40, 30, {"R", "G", "B", "A"});
    writeImage(folder / "a.exr", image);
    writeImage(folder / "b.exr", image);
    const std::string file = fileText(folder / "a.exr");
    EXPECT_EQ(file, fileText(folder / "b.exr"));
    std::vector<std::string> names;
    for (const std::string& attribute : exrAttributes(file)) {
        names.push_back(attribute.substr(0, attribute.find('=')));
        if (names.back() == "capDate") {
            EXPECT_EQ(attribute, "capDate=");  // OpenImageIO insists on having one
        }
        if (names.back() == "compression") {
            EXPECT_EQ(attribute, "compression=\x03");  // ZIP_COMPRESSION: blocks of 16 rows
        }
    }
    EXPECT_EQ(names, (std::vector<std::string>{"capDate", "channels", "compression", "dataWindow",
                                               "displayWindow", "lineOrder", "pixelAspectRatio",
                                               "screenWindowCenter", "screenWindowWidth"}));
    EXPECT_EQ(file.find("OpenImageIO"), std::string::npos);
}

TEST(ImageIo, PngHasNoDateAndIsTheSameEachTime) {
    const auto folder = scratchFolder();
    const Image image(4, 3, {"R", "G", "B", "A"});
    writeImage(folder / "a.png", image);
    writeImage(folder / "b.png", image);
    const std::string file = fileText(folder / "a.png");
    EXPECT_EQ(file, fileText(folder / "b.png"));
    for (const char* chunk : {"tIME", "eXIf", "iTXt", "zTXt", "Software", "DateTime"}) {
        EXPECT_EQ(file.find(chunk), std::string::npos) << chunk;
    }
    EXPECT_NE(file.find("sRGB"), std::string::npos);
}

TEST(ImageIo, PngStoresSrgbColourAndLinearAlphaWithoutDividing) {
    Image image(2, 1, {"Z", "B", "A", "G", "R"});
    image.pixels = {9.0f, 0.5f,  0.25f, 0.2f,   1.5f,  //
                    9.0f, -1.0f, 1.0f,  0.002f, 0.0f};
    const auto path = scratchFolder() / "colour.png";
    writeImage(path, image);
    const Image back = readImage(path);
    EXPECT_EQ(back.channelNames, (std::vector<std::string>{"R", "G", "B", "A"}));
    const std::vector<int> stored = {255, 124, 188, 64, 0, 7, 0, 255};
    for (std::size_t i = 0; i < stored.size(); ++i) {
        EXPECT_EQ(back.pixels[i], static_cast<float>(stored[i]) / 255.0f) << i;
    }
}

TEST(ImageIo, PngWithoutAlphaHasThreeChannels) {
    const auto path = scratchFolder() / "colour.png";
    writeImage(path, Image(2, 2, {"R", "G", "B"}));
    EXPECT_EQ(readImage(path).channelNames, (std::vector<std::string>{"R", "G", "B"}));
}

// Writes a file by OpenImageIO alone, as another program would.
void writeForeign(const std::filesystem::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                  const void* pixels) {
    const auto output = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(output && output->open(path.string(), spec)) << OIIO::geterror();
    ASSERT_TRUE(output->write_image(type, pixels)) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

TEST(ImageIo, PngIsReadAsStoredForEvery8BitValue) {
    std::vector<std::uint8_t> stored(256);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        stored[i] = static_cast<std::uint8_t>(i);
    }
    const auto path = scratchFolder() / "grey.png";
    writeForeign(path, OIIO::ImageSpec(256, 1, 1, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8,
                 stored.data());
    const Image image = readImage(path);
    ASSERT_EQ(image.channelNames, std::vector<std::string>{"Y"});
    for (std::size_t i = 0; i < stored.size(); ++i) {
        EXPECT_EQ(image.pixels[i], static_cast<float>(i) / 255.0f);
    }
}

TEST(ImageIo, PngOf16BitsIsReadAsStored) {
    const std::vector<std::uint16_t> stored = {0, 1, 255, 256, 32767, 65534, 65535, 12345};
    OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::UINT16);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto path = scratchFolder() / "deep.png";
    writeForeign(path, spec, OIIO::TypeDesc::UINT16, stored.data());
    const Image image = readImage(path);
    EXPECT_EQ(image.sampleType, SampleType::Unsigned16);
    ASSERT_EQ(image.pixels.size(), stored.size());
    for (std::size_t i = 0; i < stored.size(); ++i) {
        EXPECT_EQ(image.pixels[i], static_cast<float>(stored[i]) / 65535.0f) << i;
    }
}

TEST(ImageIo, HalfFloatExrIsReadExactly) {
    const std::vector<float> values = {0.5f, -0.0f, 65504.0f, 5.9604645e-8f};
    const auto path = scratchFolder() / "half.exr";
    writeForeign(path, OIIO::ImageSpec(4, 1, 1, OIIO::TypeDesc::HALF), OIIO::TypeDesc::FLOAT, values.data());
    EXPECT_EQ(readImage(path).pixels, values);
    EXPECT_EQ(readImage(path).sampleType, SampleType::Float16);

    // One channel of half floats is enough to make the image one.
    OIIO::ImageSpec mixed(2, 1, 2, OIIO::TypeDesc::FLOAT);
    mixed.channelformats = {OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::HALF};
    writeForeign(path, mixed, OIIO::TypeDesc::FLOAT, values.data());
    EXPECT_EQ(readImage(path).sampleType, SampleType::Float16);
    writeImage(path, readImage(path));  // what we write is float32
    EXPECT_EQ(readImage(path).sampleType, SampleType::Float32);
    writeImage(path.parent_path() / "flat.png", Image(2, 1, {"R", "G", "B"}));
    EXPECT_EQ(readImage(path.parent_path() / "flat.png").sampleType, SampleType::Unsigned8);
}

TEST(ImageIo, FilesThatAreMoreThanAPlainImageAreRefused) {
    const auto folder = scratchFolder();
    const std::vector<float> zeros(64, 0.0f);

    OIIO::ImageSpec cropped(4, 4, 1, OIIO::TypeDesc::FLOAT);
    cropped.full_width = 8;
    writeForeign(folder / "cropped.exr", cropped, OIIO::TypeDesc::FLOAT, zeros.data());
    expectError([&] { std::ignore = readImage(folder / "cropped.exr"); }, ExitCode::File,
                {"cropped.exr", "data window"});

    const OIIO::ImageSpec integers(4, 4, 1, OIIO::TypeDesc::UINT32);
    writeForeign(folder / "integers.exr", integers, OIIO::TypeDesc::FLOAT, zeros.data());
    expectError([&] { std::ignore = readImage(folder / "integers.exr"); }, ExitCode::File,
                {"integers.exr", "holds integers"});

    const auto output = OIIO::ImageOutput::create("openexr");
    const std::string parts = (folder / "parts.exr").string();
    const std::vector<OIIO::ImageSpec> specs(2, OIIO::ImageSpec(4, 4, 1, OIIO::TypeDesc::FLOAT));
    ASSERT_TRUE(output->open(parts, 2, specs.data()) &&
                output->write_image(OIIO::TypeDesc::FLOAT, zeros.data()));
    ASSERT_TRUE(output->open(parts, specs[1], OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, zeros.data()) && output->close());
    expectError([&] { std::ignore = readImage(parts); }, ExitCode::File, {"parts.exr", "several parts"});
}

TEST(ImageIo, ExtensionsMayBeInCapitals) {
    const auto path = scratchFolder() / "IMAGE.EXR";
    writeImage(path, Image(1, 1, {"R"}));
    EXPECT_EQ(readImage(path).width, 1);
    EXPECT_TRUE(hasImageExtension("a.Png"));
    EXPECT_FALSE(hasImageExtension("a.jpg"));
    EXPECT_FALSE(hasImageExtension("exr"));
    EXPECT_FALSE(hasImageExtension(""));
}

}  // namespace
}  // namespace raytorus::image
