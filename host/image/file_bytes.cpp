// SPDX-License-Identifier: MIT
// Whole files in and out of memory, with the reason in one sentence when it does not work.
#include "image/file_bytes.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <ios>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.hpp"

namespace raytorus::image {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failReading(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("Cannot read \"{}\": {}.", path.string(), reason));
}

[[noreturn]] void failWriting(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("Cannot write \"{}\": {}.", path.string(), reason));
}

// The system's words ("Permission denied") in the middle of a sentence.
std::string lastReason() {
    std::string reason = errno != 0 ? std::generic_category().message(errno) : "the system gives no reason";
    if (reason.front() >= 'A' && reason.front() <= 'Z') {
        reason.front() = static_cast<char>(reason.front() - 'A' + 'a');
    }
    return reason;
}

// Unique if two programs write the same file, and in the same folder so that renaming is atomic.
fs::path temporaryBeside(const fs::path& path) {
    std::random_device random;
    return path.parent_path() / fmt::format(".{}.{:08x}{:08x}", path.filename().string(), random(), random());
}

// Removes the file at the end of a scope. After a rename there is nothing left to remove.
struct RemoveAtEnd {
    fs::path path;

    explicit RemoveAtEnd(fs::path pathToRemove) : path(std::move(pathToRemove)) {}
    RemoveAtEnd(const RemoveAtEnd&) = delete;
    RemoveAtEnd& operator=(const RemoveAtEnd&) = delete;
    ~RemoveAtEnd() {
        std::error_code ignored;
        fs::remove(path, ignored);
    }
};

}  // namespace

std::vector<std::byte> readBytes(const fs::path& path) {
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (status.type() == fs::file_type::not_found) {
        failReading(path, "there is no such file");
    }
    if (fs::is_directory(status)) {
        failReading(path, "it is a directory");
    }
    // A pipe would make us wait, a device could go on for ever.
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        failReading(path, "it is not a regular file");
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) {
        failReading(path, lastReason());
    }
    const std::streamoff size = file.tellg();
    std::vector<std::byte> bytes(static_cast<std::size_t>(size > 0 ? size : 0));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) {
        failReading(path, lastReason());
    }
    return bytes;
}

void writeBytes(const fs::path& path, std::span<const std::byte> bytes) {
    std::error_code problem;
    if (fs::is_directory(path, problem)) {
        failWriting(path, "it is a directory");
    }
    const RemoveAtEnd temporary(temporaryBeside(path));
    errno = 0;
    std::ofstream file(temporary.path, std::ios::binary);
    if (!file) {
        failWriting(path, lastReason());
    }
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        failWriting(path, lastReason());
    }
    fs::rename(temporary.path, path, problem);
    if (problem) {
        errno = problem.value();
        failWriting(path, lastReason());
    }
}

}  // namespace raytorus::image
