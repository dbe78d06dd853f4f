// SPDX-License-Identifier: MIT
// Files that appear when they are complete: what is there before, meanwhile and after, and who may write it.
#include "core/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>

#include "support/expect_error.hpp"
#include "support/process_limits.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::fileText;
using test::namesIn;
using test::writeText;
using Names = std::vector<std::string>;

class OutputFiles : public testing::Test {
protected:
    void writeAll(const fs::path& path, std::string_view text) const {
        OutputFile out(path);
        out.write(text);
        out.commit();
    }
    static unsigned permissionsOf(const fs::path& path) {
        return static_cast<unsigned>(fs::status(path).permissions());
    }

    fs::path folder = test::scratchFolder();
};

TEST_F(OutputFiles, AppearWhenTheyAreComplete) {
    const fs::path path = folder / "out";
    writeText(path, "old");
    {
        OutputFile out(path);
        out.write("ne");
        EXPECT_EQ(fileText(path), "old");
        EXPECT_EQ(namesIn(folder).size(), 2U);
        out.write("w");
        out.commit();
        EXPECT_EQ(fileText(path), "new");
    }
    EXPECT_EQ(namesIn(folder), Names({"out"}));
}

TEST_F(OutputFiles, LeaveNothingUnlessTheyAre) {
    const fs::path path = folder / "out";
    {
        OutputFile out(path);
        out.write(std::string(1'000'000, 'x'));
    }
    EXPECT_EQ(namesIn(folder), Names());
}

TEST_F(OutputFiles, HoldAllThatWasWritten) {
    std::string all;
    OutputFile out(folder / "out");
    for (const std::size_t size : {1U, 65535U, 1U, 65536U, 65537U, 0U, 200'000U}) {
        const std::string part(size, static_cast<char>('a' + all.size() % 26));
        out.write(part);
        all += part;
    }
    out.commit();
    EXPECT_TRUE(fileText(folder / "out") == all);
}

TEST_F(OutputFiles, FollowALink) {
    fs::create_directory(folder / "elsewhere");
    writeText(folder / "elsewhere" / "real", "old");
    fs::create_symlink("elsewhere/real", folder / "link");
    fs::create_symlink("link", folder / "second");
    writeAll(folder / "second", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "second"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fileText(folder / "elsewhere" / "real"), "new");
    EXPECT_EQ(namesIn(folder / "elsewhere"), Names({"real"}));
    fs::create_symlink(folder / "elsewhere" / "none", folder / "dangling");
    writeAll(folder / "dangling", "made");
    EXPECT_EQ(fileText(folder / "elsewhere" / "none"), "made");
}

TEST_F(OutputFiles, RefuseALinkThatLeadsNowhere) {
    fs::create_symlink("round", folder / "round");
    expectError([&] { writeAll(folder / "round", "x"); }, ExitCode::File, {"round"});
    fs::create_symlink("missing/file", folder / "away");
    expectError([&] { writeAll(folder / "away", "x"); }, ExitCode::File, {"away", "no such file"});
}

TEST_F(OutputFiles, KeepPermissions) {
    const fs::path path = folder / "out";
    writeText(path, "old");
    for (const unsigned permissions : {0600U, 0640U, 0755U}) {
        ASSERT_EQ(chmod(path.c_str(), permissions), 0);
        writeAll(path, "new");
        EXPECT_EQ(permissionsOf(path), permissions);
    }
    const mode_t before = umask(027);
    writeAll(folder / "fresh", "new");
    umask(before);
    EXPECT_EQ(permissionsOf(folder / "fresh"), 0640U);
}

TEST_F(OutputFiles, HaveNamesAsLongAsTheSystemAllows) {
    for (const std::size_t length : {238U, 239U, 250U, 255U}) {
        const std::string name(length, 'n');
        writeAll(folder / name, name);
        EXPECT_EQ(fileText(folder / name), name);
    }
    EXPECT_EQ(namesIn(folder).size(), 4U);
    expectError([&] { writeAll(folder / std::string(256, 'n'), "x"); }, ExitCode::File, {"name too long"});
}

// A program that was killed has left one; one that still writes has another, and other files look alike.
TEST_F(OutputFiles, RemoveWhatAKilledProgramLeft) {
    writeText(folder / ".out.0123456789abcdef", "stale");
    writeText(folder / ".out.0123456789abcde", "shorter");
    writeText(folder / ".out.0123456789abcdeg", "no digits");
    writeText(folder / ".other.0123456789abcdef", "another's");
    OutputFile slow(folder / "out");
    slow.write("slow");
    writeAll(folder / "out", "quick");
    EXPECT_EQ(fileText(folder / "out"), "quick");
    EXPECT_FALSE(fs::exists(folder / ".out.0123456789abcdef"));
    EXPECT_EQ(namesIn(folder).size(), 5U)
        << "the file, the slow one's, and three that are no business of ours";
    slow.commit();
    EXPECT_EQ(fileText(folder / "out"), "slow");
}

// To look anew for each of many files takes a time that grows with their square.
TEST_F(OutputFiles, LookOnceForWhatAKilledProgramLeft) {
    writeAll(folder / "first", "x");
    writeText(folder / ".second.0123456789abcdef", "stale, from now on");
    writeAll(folder / "second", "x");
    EXPECT_EQ(namesIn(folder), Names({".second.0123456789abcdef", "first", "second"}));
}

TEST_F(OutputFiles, CanBeClosedBeforeTheyAppear) {
    const test::Limit limit(RLIMIT_NOFILE, 64);
    std::vector<std::unique_ptr<OutputFile>> files;
    for (int i = 0; i < 100; ++i) {
        files.push_back(std::make_unique<OutputFile>(folder / fmt::format("{:02}", i)));
        files.back()->write("new");
        files.back()->close();
    }
    EXPECT_FALSE(fs::exists(folder / "00"));
    for (int i = 0; i < 50; ++i) {
        files[static_cast<std::size_t>(i)]->commit();
    }
    files.clear();
    EXPECT_EQ(namesIn(folder).size(), 50U);
    EXPECT_EQ(fileText(folder / "49"), "new");
}

TEST_F(OutputFiles, RefuseWhatIsNoFile) {
    expectError([&] { writeAll(folder, "x"); }, ExitCode::File, {"it is a directory"});
    expectError([] { OutputFile out("/dev/null"); }, ExitCode::File, {"it is not a regular file"});
    expectError([&] { writeAll(folder / "missing" / "out", "x"); }, ExitCode::File, {"no such file"});
    writeText(folder / "file", "");
    expectError([&] { writeAll(folder / "file" / "out", "x"); }, ExitCode::File, {"not a directory"});
}

}  // namespace
}  // namespace raytorus
