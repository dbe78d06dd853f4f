// SPDX-License-Identifier: MIT
// What is a change of a file and when it is told, by a clock that the tests move.
#include "compile/file_watch.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <random>
#include <thread>

#include "support/fresh_seed.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::compile {
namespace {

using namespace std::chrono_literals;
using test::writeText;
namespace fs = std::filesystem;

constexpr auto quiet = 100ms;

struct FileWatches : testing::Test {
    FileWatches() : folder(test::scratchFolder()), file(folder / "a.glsl") {
        writeText(file, "one");
        watchNow({file});
    }

    // As if they had just been compiled.
    void watchNow(const std::vector<fs::path>& paths) {
        std::vector<FileState> states;
        for (const fs::path& path : paths) {
            states.push_back({path, fingerprint(readSourceFile(path))});
        }
        watch.watch(std::move(states));
    }

    std::vector<fs::path> pollAfter(std::chrono::milliseconds time) {
        now += time;
        return watch.poll();
    }

    // Noticed at once, told when it has been quiet, and told once.
    void expectChange(const fs::path& path) {
        EXPECT_EQ(pollAfter(1ms), std::vector<fs::path>());
        EXPECT_EQ(pollAfter(quiet), std::vector<fs::path>{path});
        EXPECT_EQ(pollAfter(quiet), std::vector<fs::path>());
    }

    void expectNoChange() {
        EXPECT_EQ(pollAfter(1ms), std::vector<fs::path>());
        EXPECT_EQ(pollAfter(10 * quiet), std::vector<fs::path>());
    }

    FileWatch::Clock::time_point now;
    int stamps = 0;
    std::function<FileStamp(const fs::path&)> stamp = fileStamp;
    FileWatch watch{quiet,
                    {[this] { return now; },
                     [this](const fs::path& path) {
                         ++stamps;
                         return stamp(path);
                     }}};
    fs::path folder;
    fs::path file;
};

TEST_F(FileWatches, NothingChanges) {
    expectNoChange();
    expectNoChange();
}

TEST_F(FileWatches, WrittenInPlace) {
    expectNoChange();
    writeText(file, "two");
    expectChange(file);
    writeText(file, "longer");
    expectChange(file);
}

TEST_F(FileWatches, ReplacedByRename) {
    expectNoChange();
    writeText(folder / ".a.tmp", "two");
    fs::rename(folder / ".a.tmp", file);
    expectChange(file);
}

TEST_F(FileWatches, ReplacedByOtherContentOfTheSameSizeAndDate) {
    expectNoChange();
    const auto date = fs::last_write_time(file);
    EXPECT_EQ(pollAfter(10s), std::vector<fs::path>());  // from now on the stamp is believed
    writeText(file, "two");
    fs::last_write_time(file, date);
    expectChange(file);
    EXPECT_EQ(pollAfter(10s), std::vector<fs::path>());
    writeText(folder / "b", "six");
    fs::last_write_time(folder / "b", date);
    fs::rename(folder / "b", file);
    expectChange(file);
}

TEST_F(FileWatches, DeletedAndCreatedAgain) {
    fs::remove(file);
    expectChange(file);
    writeText(file, "one");
    expectChange(file);
    fs::remove(file);
    EXPECT_EQ(pollAfter(1ms), std::vector<fs::path>());
    writeText(file, "one");  // as editors save: it comes back in time, and as it was
    expectNoChange();
}

TEST_F(FileWatches, FolderReplacedOrTakenAway) {
    const fs::path inner = folder / "sub" / "b.glsl";
    fs::create_directory(folder / "sub");
    writeText(inner, "one");
    watchNow({file, inner});
    expectNoChange();
    fs::rename(folder / "sub", folder / "old");
    expectChange(inner);
    fs::create_directory(folder / "new");
    writeText(folder / "new" / "b.glsl", "two");
    fs::rename(folder / "new", folder / "sub");
    expectChange(inner);
    fs::remove_all(folder / "sub");
    writeText(folder / "sub", "a file in its place");
    expectChange(inner);
    fs::remove(folder / "sub");
    expectNoChange();
}

TEST_F(FileWatches, LinkToAnotherFile) {
    writeText(folder / "b", "two");
    fs::create_symlink("a.glsl", folder / "link");
    watchNow({folder / "link"});
    expectNoChange();
    fs::remove(folder / "link");
    fs::create_symlink("b", folder / "link");
    expectChange(folder / "link");
}

TEST_F(FileWatches, MissingFileThatAppears) {
    const fs::path other = folder / "not" / "yet.glsl";
    watchNow({file, other});
    expectNoChange();
    fs::create_directory(folder / "not");
    expectNoChange();
    writeText(other, "");
    expectChange(other);
}

TEST_F(FileWatches, FileThatBecomesUnreadable) {
    fs::remove(file);
    fs::create_directory(file);
    expectChange(file);
    fs::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    expectChange(file);
    fs::remove(file);
    writeText(file, std::string("a\0", 2));
    expectChange(file);
    writeText(file, "one");
    expectChange(file);
}

// A scene may be larger than a shader's source, which is read whole: its size and times tell.
TEST_F(FileWatches, LargerThanASource) {
    writeText(file, std::string(maxSourceBytes + 1, 'x'));
    expectChange(file);
    writeText(file, std::string(maxSourceBytes + 2, 'x'));
    expectChange(file);
    writeText(file, std::string(maxSourceBytes + 2, 'y'));
    expectChange(file);
    watchNow({file});
    expectNoChange();
}

TEST_F(FileWatches, DatesAloneAreNoChange) {
    expectNoChange();
    fs::last_write_time(file, fs::last_write_time(file) + 1h);
    expectNoChange();
    fs::permissions(file, fs::perms::owner_read);
    expectNoChange();
    writeText(folder / "same", "one");
    fs::rename(folder / "same", file);
    expectNoChange();
}

TEST_F(FileWatches, AWriterThatGoesOnIsWaitedFor) {
    for (int i = 0; i < 20; ++i) {
        writeText(file, std::string(static_cast<std::size_t>(i) + 4, 'x'));
        EXPECT_EQ(pollAfter(quiet - 1ms), std::vector<fs::path>());
    }
    EXPECT_EQ(pollAfter(quiet - 1ms), std::vector<fs::path>());
    EXPECT_EQ(pollAfter(1ms), std::vector<fs::path>{file});
}

TEST_F(FileWatches, OneBusyFileHoldsBackTheOthers) {
    const fs::path other = folder / "b.glsl";
    writeText(other, "b");
    watchNow({file, other});
    writeText(file, "two");
    EXPECT_EQ(pollAfter(60ms), std::vector<fs::path>());
    writeText(other, "bb");
    EXPECT_EQ(pollAfter(60ms), std::vector<fs::path>());
    EXPECT_EQ(pollAfter(60ms), std::vector<fs::path>());
    EXPECT_EQ(pollAfter(60ms), (std::vector<fs::path>{file, other}));
}

TEST_F(FileWatches, ChangeBetweenReadingAndWatching) {
    const FileState read{file, fingerprint(readSourceFile(file))};
    writeText(file, "two");
    watch.watch({read});
    expectChange(file);
}

TEST_F(FileWatches, TimesOfTwoSecondsHideNothing) {
    // A file system whose times and sizes do not change at all.
    stamp = [](const fs::path&) { return FileStamp{0, 1, 2, 3, 4, 5}; };
    expectNoChange();
    writeText(file, "two");
    expectChange(file);
    now += 500ms;
    writeText(file, "six");
    EXPECT_EQ(pollAfter(0ms), std::vector<fs::path>());
    EXPECT_EQ(pollAfter(quiet), std::vector<fs::path>{file});
    // Then the stamp is old enough to be believed.
    now += 3s;
    writeText(file, "ten");
    expectNoChange();
}

TEST_F(FileWatches, QuietFilesAreAskedForOnceAPoll) {
    watchNow({file, folder / "missing"});
    stamps = 0;
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(pollAfter(1s), std::vector<fs::path>());
    }
    EXPECT_EQ(stamps, 20);
}

TEST_F(FileWatches, WatchForgetsWhatWasBefore) {
    writeText(file, "two");
    EXPECT_EQ(pollAfter(1ms), std::vector<fs::path>());
    watch.watch({});
    expectNoChange();
    watchNow({file});
    expectNoChange();
}

TEST(FileStamps, TellFilesApart) {
    const fs::path folder = test::scratchFolder();
    writeText(folder / "a", "one");
    const FileStamp first = fileStamp(folder / "a");
    EXPECT_EQ(first.error, 0);
    EXPECT_EQ(first.size, 3);
    EXPECT_EQ(fileStamp(folder / "a"), first);
    EXPECT_EQ(fileStamp(folder / "b").error, ENOENT);
    EXPECT_EQ(fileStamp(folder / "a" / "b").error, ENOTDIR);
    writeText(folder / "b", "one");
    fs::last_write_time(folder / "b", fs::last_write_time(folder / "a"));
    EXPECT_NE(fileStamp(folder / "b"), first);
    fs::last_write_time(folder / "a", fs::last_write_time(folder / "a") + 1s);
    EXPECT_EQ(fileStamp(folder / "a").modifiedNs, first.modifiedNs + 1'000'000'000);
}

// With the real clock, while another thread does everything that can be done to a file.
TEST(FileWatchRace, NothingIsThrownAndTheLastStateIsTold) {
    const fs::path folder = test::scratchFolder();
    const fs::path file = folder / "sub" / "a.glsl";
    FileWatch watch(1ms);
    watch.watch({{file, fingerprint(readSourceFile(file))}});
    {
        const std::jthread writer([&, seed = test::freshSeed()] {
            std::mt19937_64 random(seed);
            std::error_code ignored;
            for (int i = 0; i < 2000; ++i) {
                switch (random() % 5) {
                    case 0:
                        fs::create_directory(folder / "sub", ignored);
                        break;
                    case 1:
                        fs::remove_all(folder / "sub", ignored);
                        break;
                    case 2:
                        fs::create_directory(file, ignored);
                        break;
                    case 3:
                        std::ofstream(folder / "new") << i;
                        fs::rename(folder / "new", file, ignored);
                        break;
                    default:
                        std::ofstream(file) << std::string(random() % 10'000, 'x');
                }
            }
            fs::remove_all(folder / "sub", ignored);
            fs::create_directory(folder / "sub", ignored);
            std::ofstream(file) << "the last state";
        });
        for (int i = 0; i < 2000; ++i) {
            std::ignore = watch.poll();
        }
    }
    bool told = false;
    std::ignore = watch.poll();
    writeText(file, "after the last state");
    for (int i = 0; i < 1000 && !told; ++i) {
        std::this_thread::sleep_for(1ms);
        told = !watch.poll().empty();
    }
    EXPECT_TRUE(told);
}

}  // namespace
}  // namespace raytorus::compile
