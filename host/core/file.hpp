// SPDX-License-Identifier: MIT
// Files in. Every failure is an Error{ExitCode::File} that names the file and the reason in one sentence;
// none is taken for the file's end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/output_file.hpp"

namespace raytorus {

/// A regular file, read piece by piece.
class InputFile {
public:
    explicit InputFile(std::filesystem::path path);
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile();

    /// Fills the room, but at the end of the file. Returns how many bytes there are.
    std::size_t read(std::span<std::byte> room);

    /// In bytes, when it was opened.
    [[nodiscard]] std::uint64_t size() const { return bytes; }
    [[nodiscard]] const std::filesystem::path& path() const { return name; }

private:
    std::filesystem::path name;
    int file = -1;
    std::uint64_t bytes = 0;
};

/// The whole of a regular file.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path);

/// The same as text.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

/// The lines of a text, one after the other, in bounded memory.
class LineReader {
public:
    /// In bytes. A longer line is an error.
    static constexpr std::size_t longestLine = std::size_t{1} << 16U;

    explicit LineReader(const std::filesystem::path& path);

    /// The next line without its end, until the next call; nothing at the end of the file.
    std::optional<std::string_view> next();

    /// The number of the line that next() gave, from 1.
    [[nodiscard]] std::uint64_t number() const { return count; }
    /// Of the file, in bytes, when it was opened.
    [[nodiscard]] std::uint64_t size() const { return file.size(); }
    /// The bytes of all lines so far.
    [[nodiscard]] std::uint64_t position() const { return consumed; }

private:
    void requireShort(std::size_t length, std::uint64_t line) const;

    InputFile file;
    std::string buffer;
    std::size_t begin = 0;     // of what is left in the buffer
    std::size_t searched = 0;  // bytes of that without a line's end
    bool ended = false;
    std::uint64_t count = 0;
    std::uint64_t consumed = 0;
};

/// Throw Error{File}: cannot read, or write, this file, for this reason.
[[noreturn]] void failReading(const std::filesystem::path& path, std::string_view reason);
[[noreturn]] void failWriting(const std::filesystem::path& path, std::string_view reason);

/// The system's words for an errno, in the middle of a sentence: "permission denied".
std::string systemReason(int code);

}  // namespace raytorus
