// SPDX-License-Identifier: MIT
// Files of a folder that change together or not at all, even where the program is killed in the middle.
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::golden {

/// One program at a time changes the files of a folder; others wait. Until this goes, SIGHUP, SIGINT and
/// SIGTERM wait, too.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    sigset_t before{};  // the signals that waited already
    int file = -1;
};

/// New contents of several files of one folder, kept in memory until commit().
class FileGroup {
public:
    explicit FileGroup(std::filesystem::path commonFolder) : folder(std::move(commonFolder)) {}

    void add(const std::string& name, std::span<const std::byte> bytes);
    void add(const std::string& name, std::string_view text);

    /// Writes all of them beside their targets, and only then puts them in their places, in the order in
    /// which they were added. Where one fails, those before it are put back, and the Error{File} says so.
    /// Meanwhile what was there before is in the folder's ".renewal". (A power cut is not covered.) Under a
    /// FolderLock.
    void commit() const;

private:
    struct Member {
        std::string name;
        std::vector<std::byte> bytes;
    };
    std::filesystem::path folder;
    std::vector<Member> members;
};

/// Whether a commit() has not come to its end: it is under way, or its program was killed.
[[nodiscard]] bool isUnfinished(const std::filesystem::path& folder);

/// Puts back what a killed commit() has replaced. Returns whether there was anything. Under a FolderLock.
bool putBack(const std::filesystem::path& folder);

/// Whether a name in the folder is that of what commit() keeps.
[[nodiscard]] bool isKept(std::string_view name);

}  // namespace raytorus::golden
