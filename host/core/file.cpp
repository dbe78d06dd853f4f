// SPDX-License-Identifier: MIT
#include "core/file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>

#include "core/error.hpp"

namespace raytorus {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failReading(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot read \"{}\": {}", path.string(), reason));
}

[[noreturn]] void failWriting(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot write \"{}\": {}", path.string(), reason));
}

// The system's words ("Permission denied") in the middle of a sentence.
std::string systemReason(int code) {
    std::string reason = code != 0 ? std::generic_category().message(code) : "the system gives no reason";
    reason.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(reason.front())));
    return reason;
}

// Unique among programs that write the same file at once. Hidden, and in the same folder so that renaming is
// atomic.
fs::path temporaryBeside(const fs::path& path) {
    std::random_device random;
    return path.parent_path() / fmt::format(".{}.{:08x}{:08x}", path.filename().string(), random(), random());
}

}  // namespace

std::ifstream openForReading(const fs::path& path) {
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
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        failReading(path, systemReason(errno));
    }
    return file;
}

std::vector<std::byte> readFile(const fs::path& path) {
    std::ifstream file = openForReading(path);
    errno = 0;
    file.seekg(0, std::ios::end);
    const std::streamoff size = file.tellg();
    std::vector<std::byte> bytes(static_cast<std::size_t>(size > 0 ? size : 0));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) {
        failReading(path, systemReason(errno));
    }
    return bytes;
}

std::string readTextFile(const fs::path& path) {
    const std::vector<std::byte> bytes = readFile(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

OutputFile::OutputFile(fs::path path) : target(std::move(path)), temporary(temporaryBeside(target)) {
    std::error_code problem;
    if (fs::is_directory(target, problem)) {
        failWriting(target, "it is a directory");
    }
    // To rename over a device or a pipe would put a file in its place.
    const fs::file_status status = fs::status(target, problem);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        failWriting(target, "it is not a regular file");
    }
    errno = 0;
    stream.open(temporary, std::ios::binary);
    if (!stream) {
        failWriting(target, systemReason(errno));
    }
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    fs::remove(temporary, ignored);  // after commit() there is nothing left to remove
}

void OutputFile::write(std::span<const std::byte> bytes) {
    errno = 0;
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream) {
        failWriting(target, systemReason(errno));
    }
}

void OutputFile::commit() {
    errno = 0;
    stream.close();
    if (!stream) {
        failWriting(target, systemReason(errno));
    }
    std::error_code problem;
    fs::rename(temporary, target, problem);
    if (problem) {
        failWriting(target, systemReason(problem.value()));
    }
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

}  // namespace raytorus
