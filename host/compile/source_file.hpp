// SPDX-License-Identifier: MIT
// The text of a shader's file, and what tells one state of the file from another. Whatever happens to files
// while they are looked at, nothing here throws for it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace raytorus::compile {

/// The largest file, and the most text of one shader with all that it includes. The project's largest shader
/// has a tenth of it. The stack of a bounded child is measured for this much.
constexpr std::size_t maxSourceBytes = std::size_t{1} << 20U;

struct SourceFile {
    std::string text;
    /// Why there is no text, in a few words ("it is a directory"); empty if the file was read.
    std::string problem;
    /// There is no such file. One of the problems, and the only one at which a search goes on.
    bool missing = false;
    /// Of a file that is too large to be read: size and times, which tell one state of it from another.
    std::string version;
};

/// A regular file of at most maxSourceBytes, without zero bytes and byte order mark; all else is a problem.
[[nodiscard]] SourceFile readSourceFile(const std::filesystem::path& path);

/// A file as it was seen at some time.
struct FileState {
    std::filesystem::path path;  ///< absolute
    /// Equal for equal content, whatever dates say; of a file without content, why it has none.
    std::string fingerprint;
};

[[nodiscard]] std::string fingerprint(const SourceFile& file);

}  // namespace raytorus::compile
