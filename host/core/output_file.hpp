// SPDX-License-Identifier: MIT
// Files that appear under their names only when they are complete. Every failure is an Error{ExitCode::File}
// that names the file and the reason in one sentence.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace raytorus {

/// A file that is written beside its target, hidden, and then renamed. Until then, and after an error for
/// good, what was there before stays. (A power cut is not covered.)
///
/// A symbolic link is followed: the file that it names is replaced, or made. The permissions of a file that
/// is there stay. What an earlier program left beside the target because it was killed is removed.
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

    /// Finishes the file, but leaves it beside its target, and gives back its descriptor: of many files at
    /// once not all can be open. From here on another program that writes the same file may remove it.
    void close();

    /// Finishes the file. Without it nothing is left behind.
    void commit();

private:
    void create(unsigned permissions);
    void flush();
    [[noreturn]] void fail(int code) const;

    std::filesystem::path name;    // as given
    std::filesystem::path target;  // where that leads
    std::filesystem::path temporary;
    int file = -1;
    std::size_t place = 0;  // among the files that a signal removes
    std::vector<std::byte> buffer;
};

/// Throws Error{File} if no OutputFile could be written there now: better said before a long work than after
/// it.
void requireWritable(const std::filesystem::path& path);

/// Writes a whole file by OutputFile.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes what is half written, for those who end the program without leaving its functions.
void removeUnfinishedFiles() noexcept;

/// From now on SIGHUP, SIGINT and SIGTERM remove what is half written, and then end the program as ever; and
/// a file that outgrows the limit of its size (SIGXFSZ) is an error.
void cleanUpOnSignals();

}  // namespace raytorus
