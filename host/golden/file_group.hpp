// SPDX-License-Identifier: MIT
// Files that change together or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace raytorus::golden {

/// New contents of several files, kept in memory until commit().
class FileGroup {
public:
    void add(std::filesystem::path path, std::span<const std::byte> bytes);
    void add(std::filesystem::path path, std::string_view text);

    /// Writes all of them beside their targets, and only then puts them in their places, in the order in
    /// which they were added. Where one fails, those before it are put back, and the Error{File} says so.
    /// (A power cut in between is not covered.)
    void commit() const;

private:
    struct Member {
        std::filesystem::path path;
        std::vector<std::byte> bytes;
    };
    std::vector<Member> members;
};

}  // namespace raytorus::golden
