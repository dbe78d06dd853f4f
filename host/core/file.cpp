// SPDX-License-Identifier: MIT
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/descriptor.hpp"
#include "core/error.hpp"

namespace raytorus {
namespace fs = std::filesystem;

void failReading(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot read \"{}\": {}", path.string(), reason));
}

void failWriting(const fs::path& path, std::string_view reason) {
    throw Error(ExitCode::File, fmt::format("cannot write \"{}\": {}", path.string(), reason));
}

std::string systemReason(int code) {
    std::string reason = code != 0 ? std::generic_category().message(code) : "the system gives no reason";
    reason.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(reason.front())));
    return reason;
}

InputFile::InputFile(fs::path path) : name(std::move(path)) {
    std::error_code problem;
    const fs::file_status status = fs::status(name, problem);
    if (status.type() == fs::file_type::not_found) {
        failReading(name, "there is no such file");
    }
    if (fs::is_directory(status)) {
        failReading(name, "it is a directory");
    }
    // A pipe would make us wait, a device could go on for ever.
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        failReading(name, "it is not a regular file");
    }
    file = open(name.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat opened {};
    if (file < 0 || fstat(file, &opened) != 0) {
        failReading(name, systemReason(errno));
    }
    bytes = static_cast<std::uint64_t>(std::max<off_t>(opened.st_size, 0));
}

InputFile::~InputFile() {
    if (file >= 0) {
        close(file);
    }
}

std::size_t InputFile::read(std::span<std::byte> room) {
    const ssize_t got = readAll(file, room);
    if (got < 0) {
        failReading(name, systemReason(errno));
    }
    return static_cast<std::size_t>(got);
}

std::vector<std::byte> readFile(const fs::path& path) {
    InputFile file(path);
    // One byte more than the file is said to have shows that it ends there.
    std::vector<std::byte> content(file.size() + 1);
    std::size_t done = 0;
    while (true) {
        done += file.read(std::span(content).subspan(done));
        if (done < content.size()) {
            content.resize(done);
            return content;
        }
        content.resize(2 * content.size());
    }
}

std::string readTextFile(const fs::path& path) {
    const std::vector<std::byte> content = readFile(path);
    return {reinterpret_cast<const char*>(content.data()), content.size()};
}

LineReader::LineReader(const fs::path& path) : file(path) {}

std::optional<std::string_view> LineReader::next() {
    while (true) {
        const std::string_view rest = std::string_view(buffer).substr(begin);
        const std::size_t end = rest.find('\n', searched);
        if (end != std::string_view::npos || (ended && !rest.empty())) {
            const std::string_view line = rest.substr(0, end);
            begin += end != std::string_view::npos ? end + 1 : rest.size();
            searched = 0;
            ++count;
            consumed += line.size() + 1;
            requireShort(line.size(), count);
            return line;
        }
        if (ended) {
            return std::nullopt;
        }
        requireShort(rest.size(), count + 1);
        searched = rest.size();
        buffer.erase(0, begin);
        begin = 0;
        const std::size_t kept = buffer.size();
        buffer.resize(kept + longestLine);
        const std::size_t got = file.read(std::as_writable_bytes(std::span(buffer).subspan(kept)));
        ended = got < longestLine;
        buffer.resize(kept + got);
    }
}

void LineReader::requireShort(std::size_t length, std::uint64_t line) const {
    if (length > longestLine) {
        throw Error(ExitCode::File, fmt::format("\"{}\", line {}: longer than {} bytes", file.path().string(),
                                                line, longestLine));
    }
}

}  // namespace raytorus
