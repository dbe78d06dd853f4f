// SPDX-License-Identifier: MIT
// Files that change together: all of them, or none, and nothing is left beside them.
#include "golden/file_group.hpp"

#include <gtest/gtest.h>

#include "core/output_file.hpp"
#include "expect_error.hpp"
#include "file_limit.hpp"
#include "scratch_folder.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

using golden::FileGroup;

class FileGroupTest : public testing::Test {
protected:
    FileGroupTest() { writeText(folder / "old", "before"); }

    // What a file may not outgrow lets the second file fail only when it is finished, after the first has
    // been put in its place.
    void expectFailureInTheMiddle(const FileGroup& group) const {
        const Limit limit(RLIMIT_FSIZE, 1000);
        expectError([&] { group.commit(); }, ExitCode::File, {"large", "all files are as they were"});
    }

    fs::path folder = scratchFolder();
};

TEST_F(FileGroupTest, AllAreWritten) {
    FileGroup group;
    group.add(folder / "old", "after");
    group.add(folder / "new", std::string(100'000, 'x'));
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"old"});
    EXPECT_EQ(fileText(folder / "old"), "before");
    group.commit();
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"new", "old"}));
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(fileText(folder / "new"), std::string(100'000, 'x'));
}

TEST_F(FileGroupTest, NoneIsWrittenWhereOneIsADirectory) {
    fs::create_directory(folder / "directory");
    FileGroup group;
    group.add(folder / "old", "after");
    group.add(folder / "new", "new");
    group.add(folder / "directory", "no");
    expectError([&] { group.commit(); }, ExitCode::File, {"directory", "cannot write"});
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"directory", "old"}));
    EXPECT_EQ(fileText(folder / "old"), "before");
}

TEST_F(FileGroupTest, WhatWasWrittenBeforeAFailureIsPutBack) {
    fs::create_symlink("old", folder / "link");
    writeText(folder / "other", "before, too");
    FileGroup group;
    group.add(folder / "link", "after");
    group.add(folder / "new", "new");
    group.add(folder / "other", "after");
    group.add(folder / "large", std::string(10'000, 'x'));
    group.add(folder / "last", "never");
    expectFailureInTheMiddle(group);
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"link", "old", "other"}));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fileText(folder / "old"), "before");
    EXPECT_EQ(fileText(folder / "other"), "before, too");
    group.commit();
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(fileText(folder / "last"), "never");
}

TEST_F(FileGroupTest, WhatCannotBeWrittenIsKnownBefore) {
    fs::create_directory(folder / "directory");
    expectError([&] { requireWritable(folder / "directory"); }, ExitCode::File, {"directory"});
    expectError([&] { requireWritable(folder / "none" / "file"); }, ExitCode::File, {"none"});
    expectError([&] { requireWritable(folder / "old" / "file"); }, ExitCode::File, {"old"});
    requireWritable(folder / "old");
    requireWritable(folder / "new");
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"directory", "old"}));
    EXPECT_EQ(fileText(folder / "old"), "before");
}

}  // namespace
}  // namespace raytorus::test
