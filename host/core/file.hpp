// SPDX-License-Identifier: MIT
// Files in and out. Every failure is an Error{ExitCode::File} that names the file and the reason in one
// sentence, and no output file is ever seen half written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace raytorus {

/// A regular file, opened for reading.
[[nodiscard]] std::ifstream openForReading(const std::filesystem::path& path);

/// The whole of a regular file.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path);

/// The same as text.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

/// A file that appears under its name only when it is complete: it is written beside it and then renamed.
/// Until then, and after an error for good, what was there before stays. (A power cut is not covered.)
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

    /// Finishes the file. Without it nothing is left behind.
    void commit();

private:
    std::filesystem::path target;
    std::filesystem::path temporary;
    std::ofstream stream;
};

/// Writes a whole file by OutputFile.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace raytorus
