// SPDX-License-Identifier: MIT
// Files piece by piece and line by line: what is the end, and what is none.
#include <gtest/gtest.h>

#include <array>

#include "core/file.hpp"
#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus {
namespace {

using test::expectError;

class InputFiles : public testing::Test {
protected:
    std::filesystem::path file(const std::string& text) const {
        test::writeText(folder / "file", text);
        return folder / "file";
    }
    std::vector<std::string> linesOf(const std::string& text) const {
        LineReader reader(file(text));
        std::vector<std::string> lines;
        while (const std::optional<std::string_view> line = reader.next()) {
            lines.emplace_back(*line);
            EXPECT_EQ(reader.number(), lines.size());
        }
        EXPECT_EQ(reader.next(), std::nullopt) << "the end stays";
        return lines;
    }

    std::filesystem::path folder = test::scratchFolder();
};

using Lines = std::vector<std::string>;

TEST_F(InputFiles, LinesEndAtTheirEnds) {
    EXPECT_EQ(linesOf(""), Lines());
    EXPECT_EQ(linesOf("a"), Lines({"a"}));
    EXPECT_EQ(linesOf("a\n"), Lines({"a"}));
    EXPECT_EQ(linesOf("\n\na\n\nb"), Lines({"", "", "a", "", "b"}));
    EXPECT_EQ(linesOf("a\r\nb\r\n"), Lines({"a\r", "b\r"}));
    EXPECT_EQ(linesOf(std::string("a\0b\nc", 5)), Lines({std::string("a\0b", 3), "c"}));
}

// Around the pieces in which the file is read.
TEST_F(InputFiles, LinesOfEveryLength) {
    constexpr std::size_t most = LineReader::longestLine;
    for (const std::size_t length : {most - 2, most - 1, most}) {
        const std::string line(length, 'x');
        EXPECT_EQ(linesOf(line), Lines({line})) << length;
        EXPECT_EQ(linesOf(line + "\n"), Lines({line})) << length;
        EXPECT_EQ(linesOf("a\n" + line + "\n" + line + "\nb"), Lines({"a", line, line, "b"})) << length;
    }
}

TEST_F(InputFiles, LinesThatAreTooLong) {
    const std::string tooLong(LineReader::longestLine + 1, 'x');
    for (const std::string& text :
         {"a\n" + tooLong, "a\n" + tooLong + "\nb", "a\n" + std::string(10'000'000, 'x')}) {
        expectError([&] { static_cast<void>(linesOf(text)); }, ExitCode::File, {"file", "line 2", "65536"});
    }
}

TEST_F(InputFiles, PiecesAreFullButTheLast) {
    InputFile input(file("0123456789"));
    EXPECT_EQ(input.size(), 10U);
    std::array<std::byte, 4> room{};
    EXPECT_EQ(input.read(room), 4U);
    EXPECT_EQ(input.read(room), 4U);
    EXPECT_EQ(input.read(room), 2U);
    EXPECT_EQ(room[1], std::byte{'9'});
    EXPECT_EQ(input.read(room), 0U);
}

// The system's own files have no size before they are read.
TEST_F(InputFiles, OfNoStatedSize) {
    EXPECT_FALSE(readFile("/proc/self/status").empty());
    EXPECT_EQ(readTextFile(file(std::string(100'000, 'x'))), std::string(100'000, 'x'));
}

// Nothing is there at the beginning of a process's memory: the kernel says EIO.
TEST_F(InputFiles, AFailureIsNoEnd) {
    expectError([] { static_cast<void>(readFile("/proc/self/mem")); }, ExitCode::File,
                {"cannot read \"/proc/self/mem\": input/output error"});
    LineReader reader("/proc/self/mem");
    expectError([&] { static_cast<void>(reader.next()); }, ExitCode::File, {"input/output error"});
}

}  // namespace
}  // namespace raytorus
