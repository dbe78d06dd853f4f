// SPDX-License-Identifier: MIT
// A list of the pictures in a folder with their SHA-256: what was agreed on is what is compared with.
//   {"files": {"ring.exr": {"sha256": "<64 hexadecimal digits>", "bytes": 53012}}}
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace raytorus::image {

struct ManifestEntry {
    std::string sha256;  ///< 64 lower case hexadecimal digits
    std::uintmax_t bytes = 0;

    friend bool operator==(const ManifestEntry&, const ManifestEntry&) = default;
};

struct Manifest {
    std::map<std::string, ManifestEntry, std::less<>> files;  ///< by name, without any folder

    friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Throws Error{ExitCode::File} when the file is missing or is no manifest.
[[nodiscard]] Manifest readManifest(const std::filesystem::path& path);

/// The entry of a file with these bytes.
[[nodiscard]] ManifestEntry manifestEntry(std::span<const std::byte> bytes);

/// As readManifest() reads it, names sorted. Throws Error{ExitCode::File} for a name that is not UTF-8, which
/// JSON cannot hold.
[[nodiscard]] std::string manifestText(const Manifest& manifest);

/// Writes that in one step like writeFile().
void writeManifest(const std::filesystem::path& path, const Manifest& manifest);

/// A manifest of every picture (hasImageExtension) in a folder.
[[nodiscard]] Manifest manifestOf(const std::filesystem::path& folder);

/// Why a file is not the one that the manifest lists under its name: not listed, missing, truncated, changed.
/// Empty when it is.
[[nodiscard]] std::string manifestFault(const Manifest& manifest, const std::filesystem::path& file);

/// What is wrong with a folder, a sentence each, by name: files that are listed and missing or changed, and
/// pictures that are there and not listed.
[[nodiscard]] std::vector<std::string> manifestFaults(const Manifest& manifest,
                                                      const std::filesystem::path& folder);

}  // namespace raytorus::image
