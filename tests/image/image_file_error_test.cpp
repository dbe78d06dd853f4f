// SPDX-License-Identifier: MIT
// Files that cannot be read or written: one sentence with the name and the reason, and nothing half done.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "image/image_codec.hpp"
#include "image/image_io.hpp"
#include "support/expect_error.hpp"
#include "support/process_limits.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::image {
namespace {

using test::expectError;
using test::fileText;
using test::namesIn;
using test::scratchFolder;
using test::writeText;

Image gradient(int width, int height) {
    Image image(width, height, {"R", "G", "B", "A"});
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = static_cast<float>(i) / static_cast<float>(image.pixels.size());
    }
    return image;
}

void expectUnreadable(const std::filesystem::path& path, const std::string& reason) {
    expectError([&] { std::ignore = readImage(path); }, ExitCode::File, {path.filename().string(), reason});
}

TEST(ImageFileError, MissingFile) {
    expectUnreadable(scratchFolder() / "missing.exr", "there is no such file");
    expectUnreadable(scratchFolder() / "missing folder" / "missing.exr", "there is no such file");
}

TEST(ImageFileError, Directory) {
    const auto path = scratchFolder() / "folder.exr";
    std::filesystem::create_directory(path);
    expectUnreadable(path, "it is a directory");
    expectError([&] { writeImage(path, gradient(2, 2)); }, ExitCode::File,
                {"folder.exr", "it is a directory"});
    EXPECT_EQ(namesIn(path.parent_path()), std::vector<std::string>{"folder.exr"});
}

TEST(ImageFileError, PipeIsNotWaitedFor) {
    const auto path = scratchFolder() / "pipe.exr";
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    expectUnreadable(path, "it is not a regular file");
}

TEST(ImageFileError, NoPermission) {
    const auto folder = scratchFolder();
    const auto path = folder / "secret.exr";
    writeImage(path, gradient(2, 2));
    std::filesystem::permissions(path, std::filesystem::perms::none);
    std::filesystem::permissions(folder, static_cast<std::filesystem::perms>(0555));
    {
        const test::WithoutPrivileges guard;
        expectUnreadable(path, "permission denied");
        expectError([&] { writeImage(folder / "new.exr", gradient(2, 2)); }, ExitCode::File,
                    {"new.exr", "permission denied"});
    }
    std::filesystem::permissions(folder, static_cast<std::filesystem::perms>(0755));
    std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0644));
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"secret.exr"});
}

TEST(ImageFileError, WrongContentOrExtension) {
    const auto folder = scratchFolder();
    writeText(folder / "empty.exr", "");
    expectUnreadable(folder / "empty.exr", "it is empty");
    writeText(folder / "text.exr", "This is no image.");
    expectUnreadable(folder / "text.exr", "not an image in the OpenEXR format");
    writeImage(folder / "real.png", gradient(2, 2));
    std::filesystem::rename(folder / "real.png", folder / "really png.exr");
    expectUnreadable(folder / "really png.exr", "not an image in the OpenEXR format");
    writeImage(folder / "real.exr", gradient(2, 2));
    std::filesystem::rename(folder / "real.exr", folder / "really exr.png");
    expectUnreadable(folder / "really exr.png", "not an image in the PNG format");
    writeText(folder / "image.jpg", "");
    expectUnreadable(folder / "image.jpg", ".exr or .png");
    expectError([&] { writeImage(folder / "new.jpg", gradient(2, 2)); }, ExitCode::File,
                {"new.jpg", ".exr or .png"});
    expectError([&] { writeImage(folder / "exr", gradient(2, 2)); }, ExitCode::File, {".exr or .png"});
}

TEST(ImageFileError, EveryTruncationOfAFileIsAnError) {
    const Image image = gradient(1, 40);  // three blocks of rows in an EXR
    for (const Format format : {Format::Exr, Format::Png}) {
        const std::vector<std::byte> bytes = encode(image, format, "whole");
        EXPECT_EQ(decode(bytes, format, "whole").height, 40);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            SCOPED_TRACE("cut to " + std::to_string(size) + " of " + std::to_string(bytes.size()));
            expectError([&] { std::ignore = decode(std::span(bytes).first(size), format, "cut"); },
                        ExitCode::File, {"cannot read \"cut\": "});
        }
    }
}

// Whatever a damaged header says, the answer is an error or an image, never a crash.
TEST(ImageFileError, DamagedBytesNeverDoMoreThanFail) {
    const Image image = gradient(1, 20);
    for (const Format format : {Format::Exr, Format::Png}) {
        const std::vector<std::byte> bytes = encode(image, format, "whole");
        int refused = 0;
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (const std::byte flip : {std::byte{0x01}, std::byte{0x80}, std::byte{0xff}}) {
                std::vector<std::byte> damaged = bytes;
                damaged[at] ^= flip;
                try {
                    std::ignore = decode(damaged, format, "damaged");
                } catch (const Error& error) {
                    EXPECT_EQ(error.exitCode, ExitCode::File) << error.what();
                    ++refused;
                }
            }
        }
        // A PNG has a checksum for every byte. An EXR has one for zipped pixels, not for its header.
        const auto most = static_cast<int>(3 * bytes.size());
        EXPECT_GE(refused, format == Format::Png ? most : most / 2);
    }
}

TEST(ImageFileError, HeaderOfAHugeImageIsRefusedBeforeMemoryIsTaken) {
    std::vector<std::byte> bytes = encode(gradient(4, 4), Format::Exr, "small");
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const char* window : {"dataWindow", "displayWindow"}) {
        // After the name come the type "box2i", the size, and then xMin yMin xMax yMax.
        const std::size_t at =
            text.find(std::string_view(window, std::strlen(window))) + std::strlen(window) + 7 + 4;
        const std::int32_t last = 199999;
        std::memcpy(bytes.data() + at + 8, &last, sizeof last);
    }
    expectError([&] { std::ignore = decode(bytes, Format::Exr, "huge"); }, ExitCode::File, {"200000 x 4"});
}

TEST(ImageFileError, PngOfWhatIsNoColourOrNoNumber) {
    const auto folder = scratchFolder();
    expectError(
        [&] {
            writeImage(folder / "depth.png", Image(2, 2, {"R", "B", "Z"}));
        },
        ExitCode::File, {"depth.png", "no G"});
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            Image image = gradient(3, 2);
            image.pixel(2, 1)[channel] = bad;
            expectError([&] { writeImage(folder / "bad.png", image); }, ExitCode::NonFinite,
                        {"bad.png", "channel " + image.channelNames[channel], "(2, 1)"});
        }
    }
    EXPECT_EQ(namesIn(folder), std::vector<std::string>());
}

TEST(ImageFileError, ImagesThatContradictThemselvesAreNotWritten) {
    Image image = gradient(3, 2);
    image.pixels.pop_back();
    const auto folder = scratchFolder();
    expectError([&] { writeImage(folder / "short.exr", image); }, ExitCode::Internal,
                {"short.exr", "does not match"});
    expectError([&] { writeImage(folder / "none.exr", Image()); }, ExitCode::Internal, {"none.exr", "0 x 0"});
    EXPECT_EQ(namesIn(folder), std::vector<std::string>());
}

TEST(ImageFileError, FolderThatIsMissingOrAFile) {
    const auto folder = scratchFolder();
    expectError([&] { writeImage(folder / "missing" / "a.exr", gradient(2, 2)); }, ExitCode::File,
                {"a.exr", "no such file or directory"});
    writeText(folder / "file", "");
    expectError([&] { writeImage(folder / "file" / "a.exr", gradient(2, 2)); }, ExitCode::File,
                {"a.exr", "not a directory"});
}

TEST(ImageFileError, ADiskThatIsFullLeavesTheOldFileAndNothingElse) {
    const auto folder = scratchFolder();
    writeImage(folder / "a.exr", gradient(2, 2));
    const std::string before = fileText(folder / "a.exr");
    {
        const test::Limit limit(RLIMIT_FSIZE, 1000);  // a file that grows further fails, as on a full disk
        expectError([&] { writeImage(folder / "a.exr", gradient(200, 200)); }, ExitCode::File,
                    {"a.exr\": file too large"});
    }
    EXPECT_EQ(fileText(folder / "a.exr"), before);
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"a.exr"});
}

TEST(ImageFileError, WritingReplacesAnOldFileWhole) {
    const auto folder = scratchFolder();
    writeText(folder / "a.exr", std::string(1'000'000, 'x'));
    writeImage(folder / "a.exr", gradient(2, 2));
    EXPECT_EQ(readImage(folder / "a.exr").pixels, gradient(2, 2).pixels);
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"a.exr"});
}

}  // namespace
}  // namespace raytorus::image
