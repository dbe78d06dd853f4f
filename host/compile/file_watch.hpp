// SPDX-License-Identifier: MIT
// Tells when files are no longer what they were, by asking at every frame: no thread, no descriptors, any
// file system, and folders may come and go.
//
//     FileWatch watch;
//     watch.watch(shader.files);
//     each frame: if (!watch.poll().empty()) compile again, and watch what that read
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compile/source_file.hpp"

namespace raytorus::compile {

/// What the system says of a file without reading it. Two different contents may have the same stamp, if the
/// second was written within the granularity of the system's times.
struct FileStamp {
    int error = 0;  ///< errno; 0: there is such a file
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t modifiedNs = 0;
    std::int64_t changedNs = 0;  ///< the inode's own time, which no program can set back

    bool operator==(const FileStamp&) const = default;
};

/// Follows symbolic links. Never throws.
[[nodiscard]] FileStamp fileStamp(const std::filesystem::path& path);

class FileWatch {
public:
    using Clock = std::chrono::steady_clock;

    /// What tests replace.
    struct System {
        std::function<Clock::time_point()> now = Clock::now;
        std::function<FileStamp(const std::filesystem::path&)> stamp = fileStamp;
    };

    /// A change is told once no content has changed for `quiet`: editors write in steps.
    explicit FileWatch(std::chrono::milliseconds quiet = std::chrono::milliseconds(100))
        : FileWatch(quiet, System()) {}
    FileWatch(std::chrono::milliseconds quiet, System system);

    /// From now on these files, compared with the states given: what has changed since then is told, too.
    void watch(std::vector<FileState> files);

    /// The files whose content is another than when last told, in the order of watch(); or none. Dates alone,
    /// or content that comes back in time, are no change. Takes some microseconds a file, and never throws
    /// for what happens to one.
    [[nodiscard]] std::vector<std::filesystem::path> poll();

private:
    struct Watched {
        FileState told;
        std::string present;
        FileStamp stamp;
        Clock::time_point stampSince;
        bool read = false;
    };

    void look(Watched& file, Clock::time_point now);

    std::chrono::milliseconds quietTime;
    System files;
    std::vector<Watched> watched;
    Clock::time_point lastChange;
};

}  // namespace raytorus::compile
