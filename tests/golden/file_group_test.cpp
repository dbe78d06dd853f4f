// SPDX-License-Identifier: MIT
// Files that change together: all of them, or none, and nothing is left beside them.
#include "golden/file_group.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/output_file.hpp"
#include "failing_rename.hpp"
#include "support/expect_error.hpp"
#include "support/process_limits.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::test {
namespace {

namespace fs = std::filesystem;

using golden::FileGroup;

class FileGroupTest : public testing::Test {
protected:
    FileGroupTest() { writeText(folder / "old", "before"); }

    // Those before it are in their places by then.
    void expectFailureAt(const FileGroup& group, const std::string& name) const {
        const FailingRename failing(name);
        expectError([&] { group.commit(); }, ExitCode::File,
                    {name, "read-only", "all files are as they were"});
    }

    // As a program does that is killed before this file is put in its place.
    void leaveUnfinished(const FileGroup& group, const std::string& name) const {
        const pid_t child = fork();
        if (child == 0) {
            killAtRename(name);
            group.commit();
            _exit(0);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status)) << status;
    }

    fs::path folder = scratchFolder();
};

TEST_F(FileGroupTest, AllAreWritten) {
    FileGroup group(folder);
    group.add("old", "after");
    group.add("new", std::string(100'000, 'x'));
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"old"});
    EXPECT_EQ(fileText(folder / "old"), "before");
    group.commit();
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"new", "old"}));
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(fileText(folder / "new"), std::string(100'000, 'x'));
}

TEST_F(FileGroupTest, NoneIsWrittenWhereOneIsADirectory) {
    fs::create_directory(folder / "directory");
    FileGroup group(folder);
    group.add("old", "after");
    group.add("new", "new");
    group.add("directory", "no");
    expectError([&] { group.commit(); }, ExitCode::File, {"directory", "cannot write"});
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"directory", "old"}));
    EXPECT_EQ(fileText(folder / "old"), "before");
}

TEST_F(FileGroupTest, WhatWasWrittenBeforeAFailureIsPutBack) {
    fs::create_symlink("old", folder / "link");
    writeText(folder / "other", "before, too");
    FileGroup group(folder);
    group.add("link", "after");
    group.add("new", "new");
    group.add("other", "after");
    group.add("large", std::string(10'000, 'x'));
    group.add("last", "never");
    expectFailureAt(group, "large");
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"link", "old", "other"}));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fileText(folder / "old"), "before");
    EXPECT_EQ(fileText(folder / "other"), "before, too");
    group.commit();
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(fileText(folder / "last"), "never");
}

TEST_F(FileGroupTest, AFileThatDoesNotFitChangesNothing) {
    FileGroup group(folder);
    group.add("old", "after");
    group.add("large", std::string(10'000, 'x'));
    const Limit limit(RLIMIT_FSIZE, 1000);
    expectError([&] { group.commit(); }, ExitCode::File, {"large", "file too large"});
    EXPECT_EQ(namesIn(folder), std::vector<std::string>{"old"});
    EXPECT_EQ(fileText(folder / "old"), "before");
}

// "cannot write ...: too many open files" from some 500 cases on
TEST_F(FileGroupTest, MoreFilesThanMayBeOpen) {
    FileGroup group(folder);
    for (int i = 0; i < 300; ++i) {
        group.add(fmt::format("{:03}", i), "new");
    }
    {
        const Limit limit(RLIMIT_NOFILE, 100);
        group.commit();
    }
    EXPECT_EQ(namesIn(folder).size(), 301U);
}

TEST_F(FileGroupTest, WhatAKilledProgramHasReplacedIsPutBack) {
    fs::create_directory(folder / "elsewhere");
    writeText(folder / "elsewhere" / "real", "before, too");
    fs::create_symlink("elsewhere/real", folder / "link");
    FileGroup group(folder);
    group.add("old", "after");
    group.add("new", "new");
    group.add("link", "after");
    group.add("last", "never");
    EXPECT_FALSE(golden::isUnfinished(folder));
    EXPECT_FALSE(golden::putBack(folder));
    // At each file, and at the end of it all: nothing, some or all of them are in their places.
    for (const char* name : {"old", "new", "real", "last", ".renewal-done"}) {
        leaveUnfinished(group, name);
        EXPECT_TRUE(golden::isUnfinished(folder));
        EXPECT_EQ(fs::exists(folder / "new"), std::string(name) != "old" && std::string(name) != "new");
        // A second group has to wait for that.
        expectError([&] { group.commit(); }, ExitCode::File, {".renewal", "exists"});
        EXPECT_TRUE(golden::putBack(folder));
        EXPECT_FALSE(golden::isUnfinished(folder));
        EXPECT_EQ(fileText(folder / "old"), "before");
        EXPECT_EQ(fileText(folder / "link"), "before, too");
        EXPECT_TRUE(fs::is_symlink(folder / "link"));
        EXPECT_FALSE(fs::exists(folder / "new"));
        EXPECT_FALSE(fs::exists(folder / "last"));
    }
    group.commit();
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(fileText(folder / "elsewhere" / "real"), "after");
    EXPECT_EQ(fileText(folder / "last"), "never");
    EXPECT_FALSE(golden::isUnfinished(folder));
}

// Ended in the middle of that, too.
TEST_F(FileGroupTest, PuttingBackGoesOnWhereItWasEnded) {
    writeText(folder / "other", "before, too");
    FileGroup group(folder);
    group.add("old", "after");
    group.add("other", "after");
    group.add("last", "never");
    leaveUnfinished(group, "last");
    {
        const FailingRename failing("old");
        expectError([&] { golden::putBack(folder); }, ExitCode::File, {"old", "could not be put back"});
    }
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_TRUE(golden::putBack(folder));
    EXPECT_EQ(fileText(folder / "old"), "before");
    EXPECT_EQ(fileText(folder / "other"), "before, too");
}

TEST_F(FileGroupTest, ASignalWaitsUntilAllFilesAreThere) {
    const pid_t child = fork();
    if (child == 0) {
        FileGroup group(folder);
        group.add("old", "after");
        group.add("new", "new");
        {
            const golden::FolderLock lock(folder);
            raise(SIGTERM);
            group.commit();
        }
        _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
    EXPECT_EQ(fileText(folder / "old"), "after");
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"new", "old"}));
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
