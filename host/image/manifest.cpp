// SPDX-License-Identifier: MIT
// Pictures and their SHA-256.
#include "image/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/console.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_text.hpp"
#include "core/sha256.hpp"
#include "core/strict_json.hpp"
#include "image/image_io.hpp"

namespace raytorus::image {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw Error(ExitCode::File, fmt::format("\"{}\" is not a manifest: {}", path.string(), reason));
}

Json parse(const fs::path& path) {
    const std::string text = readTextFile(path);
    try {
        return parseStrictJson(text, path.string());
    } catch (const Error& error) {
        throw Error(ExitCode::File, error.what());  // not of a scene
    }
}

bool isSha256(std::string_view text) {
    return text.size() == 64 &&
           std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

ManifestEntry entryOf(const fs::path& path, const std::string& name, const Json& json) {
    if (name.empty() || name.find('/') != std::string::npos || name == "." || name == "..") {
        fail(path, fmt::format("\"{}\" is not the name of a file beside it", name));
    }
    const auto sha256 = json.find("sha256");
    if (sha256 == json.end() || !sha256->is_string() || !isSha256(sha256->get<std::string>())) {
        fail(path, fmt::format("\"sha256\" of \"{}\" must be 64 lower case hexadecimal digits", name));
    }
    const auto bytes = json.find("bytes");
    if (bytes == json.end() || !bytes->is_number_unsigned()) {
        fail(path, fmt::format("\"bytes\" of \"{}\" must be a whole number that is not negative", name));
    }
    return {sha256->get<std::string>(), bytes->get<std::uintmax_t>()};
}

std::set<std::string> picturesIn(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        if (hasImageExtension(entry->path())) {
            names.insert(entry->path().filename().string());
        }
    }
    if (problem) {
        throw Error(ExitCode::File, fmt::format("cannot list the folder \"{}\": {}", folder.string(),
                                                systemReason(problem.value())));
    }
    return names;
}

}  // namespace

ManifestEntry manifestEntry(std::span<const std::byte> bytes) {
    return {sha256(bytes), bytes.size()};
}

Manifest readManifest(const fs::path& path) {
    const Json json = parse(path);
    if (!json.is_object() || !json.contains("files") || !json["files"].is_object()) {
        fail(path, "it has no object \"files\"");
    }
    Manifest manifest;
    for (const auto& [name, entry] : json["files"].items()) {
        manifest.files[name] = entryOf(path, name, entry);
    }
    return manifest;
}

std::string manifestText(const Manifest& manifest) {
    Json files = Json::object();
    for (const auto& [name, entry] : manifest.files) {
        if (!isUtf8(name)) {
            throw Error(ExitCode::File,
                        fmt::format("\"{}\" cannot be in a manifest: its name is not UTF-8", name));
        }
        files[name] = {{"sha256", entry.sha256}, {"bytes", entry.bytes}};
    }
    return dumpJson({{"files", files}}) + "\n";
}

void writeManifest(const fs::path& path, const Manifest& manifest) {
    const std::string text = manifestText(manifest);
    writeFile(path, std::as_bytes(std::span(text)));
}

Manifest manifestOf(const fs::path& folder) {
    Manifest manifest;
    for (const std::string& name : picturesIn(folder)) {
        manifest.files[name] = manifestEntry(readFile(folder / name));
    }
    return manifest;
}

std::string manifestFault(const Manifest& manifest, const fs::path& file) {
    const auto listed = manifest.files.find(file.filename().string());
    if (listed == manifest.files.end()) {
        return fmt::format("\"{}\" is not in the manifest", file.string());
    }
    const ManifestEntry& expected = listed->second;
    ManifestEntry found;
    try {
        found = manifestEntry(readFile(file));
    } catch (const Error& error) {
        return fmt::format("{}, and the manifest lists it", error.what());
    }
    if (found.bytes < expected.bytes) {
        return fmt::format("\"{}\" is truncated: it has {} of the {} bytes that the manifest lists",
                           file.string(), found.bytes, expected.bytes);
    }
    if (found != expected) {
        return fmt::format(
            "\"{}\" is not the file that the manifest lists: {} bytes with the SHA-256 {}, not "
            "{} bytes with {}",
            file.string(), found.bytes, found.sha256, expected.bytes, expected.sha256);
    }
    return {};
}

std::vector<std::string> manifestFaults(const Manifest& manifest, const fs::path& folder) {
    std::set<std::string> names = picturesIn(folder);
    for (const auto& [name, entry] : manifest.files) {
        names.insert(name);
    }
    std::vector<std::string> faults;
    for (const std::string& name : names) {
        if (std::string fault = manifestFault(manifest, folder / name); !fault.empty()) {
            faults.push_back(std::move(fault));
        }
    }
    return faults;
}

}  // namespace raytorus::image
