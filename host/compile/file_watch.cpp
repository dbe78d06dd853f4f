// SPDX-License-Identifier: MIT
#include "compile/file_watch.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

namespace raytorus::compile {
namespace {

// FAT has the coarsest times in use, of 2 s. While a stamp is younger than that, other content may still come
// to have the same one.
constexpr std::chrono::milliseconds coarsestTimes{2100};

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileStamp fileStamp(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        return {.error = errno};
    }
    return {0,
            status.st_dev,
            status.st_ino,
            status.st_size,
            nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

FileWatch::FileWatch(std::chrono::milliseconds quiet, System system)
    : quietTime(quiet), files(std::move(system)), lastChange(files.now()) {}

void FileWatch::watch(std::vector<FileState> states) {
    watched.clear();
    for (FileState& state : states) {
        std::string present = state.fingerprint;
        watched.push_back({std::move(state), std::move(present), {}, {}, false});
    }
}

void FileWatch::look(Watched& file, Clock::time_point now) {
    // First the stamp, then the content: if somebody writes between the two, the next stamp is another.
    const FileStamp stamp = files.stamp(file.told.path);
    if (!file.read || stamp != file.stamp) {
        file.stamp = stamp;
        file.stampSince = now;
    } else if (now - file.stampSince > coarsestTimes) {
        return;
    }
    file.read = true;
    std::string content = fingerprint(readSourceFile(file.told.path));
    if (content != file.present) {
        file.present = std::move(content);
        lastChange = now;
    }
}

std::vector<std::filesystem::path> FileWatch::poll() {
    const Clock::time_point now = files.now();
    for (Watched& file : watched) {
        look(file, now);
    }
    std::vector<std::filesystem::path> changed;
    if (now - lastChange < quietTime) {
        return changed;
    }
    for (Watched& file : watched) {
        if (file.present != file.told.fingerprint) {
            file.told.fingerprint = file.present;
            changed.push_back(file.told.path);
        }
    }
    return changed;
}

}  // namespace raytorus::compile
