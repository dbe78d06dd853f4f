// SPDX-License-Identifier: MIT
#include "compile/source_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <span>

#include "core/file.hpp"
#include "core/sha256.hpp"

namespace raytorus::compile {
namespace {

class Descriptor {
public:
    // Without O_NONBLOCK a pipe would keep us until somebody writes into it.
    explicit Descriptor(const std::filesystem::path& path)
        : number(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) {
            ::close(number);
        }
    }

    const int number;
};

SourceFile unreadable(std::string problem) {
    return {{}, std::move(problem), false, {}};
}

SourceFile failed(int code) {
    // Also if what should be a folder above it is a file.
    if (code == ENOENT || code == ENOTDIR) {
        return {{}, "there is no such file", true, {}};
    }
    return unreadable(systemReason(code));
}

}  // namespace

SourceFile readSourceFile(const std::filesystem::path& path) {
    const Descriptor file(path);
    struct stat status {};
    if (file.number < 0 || ::fstat(file.number, &status) != 0) {
        return failed(errno);
    }
    if (S_ISDIR(status.st_mode)) {
        return unreadable("it is a directory");
    }
    if (!S_ISREG(status.st_mode)) {
        return unreadable("it is not a regular file");
    }
    // Until its end, not for the size that it had: somebody may be writing.
    constexpr std::size_t step = std::size_t{1} << 16U;
    SourceFile source;
    std::size_t size = 0;
    for (ssize_t count = 1; count != 0;) {
        source.text.resize(size + step);
        count = ::read(file.number, source.text.data() + size, step);
        if (count < 0 && errno != EINTR) {
            return failed(errno);
        }
        size += count > 0 ? static_cast<std::size_t>(count) : 0;
        if (size > maxSourceBytes) {
            SourceFile tooLarge = unreadable(fmt::format("it has more than {} bytes", maxSourceBytes));
            tooLarge.version =
                fmt::format(" {} {} {}.{:09} {}.{:09}", status.st_ino, status.st_size, status.st_mtim.tv_sec,
                            status.st_mtim.tv_nsec, status.st_ctim.tv_sec, status.st_ctim.tv_nsec);
            return tooLarge;
        }
    }
    source.text.resize(size);
    source.text.shrink_to_fit();
    if (const std::size_t at = source.text.find('\0'); at != std::string::npos) {
        return unreadable(fmt::format("it is no text, byte {} is zero", at));
    }
    if (source.text.starts_with("\xef\xbb\xbf")) {
        return unreadable("it begins with a byte order mark, which GLSL does not know");
    }
    return source;
}

std::string fingerprint(const SourceFile& file) {
    return file.problem.empty() ? sha256(std::as_bytes(std::span(file.text))) : file.problem + file.version;
}

}  // namespace raytorus::compile
