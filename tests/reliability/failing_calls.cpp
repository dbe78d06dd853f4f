// SPDX-License-Identifier: MIT
// System calls that fail as a disk does, for a program that is started with this library in LD_PRELOAD. Of
// the files whose names end in FAIL_NAME:
//
//     FAIL_READ=N       read() gives EIO from byte N on
//     FAIL_CLOSE=1      close() gives ENOSPC, once the file is closed
//     FAIL_RENAME=1     rename() to them gives EROFS
//     FAIL_RENAME=kill  it ends the program, as if by somebody else
//
// FAIL_THREADS=1: there are no more threads.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

template <typename Function>
Function original(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool isNamed(std::string_view path) {
    const char* const name = std::getenv("FAIL_NAME");
    return name != nullptr && path.find(name) != std::string_view::npos;
}

// By the system's own list: there is no need to follow every way of opening a file.
bool isNamed(int file) {
    std::array<char, PATH_MAX> path{};
    const std::string link = "/proc/self/fd/" + std::to_string(file);
    const ssize_t length = readlink(link.c_str(), path.data(), path.size());
    return length > 0 && isNamed(std::string_view(path.data(), static_cast<std::size_t>(length)));
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                              void* argument) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    return std::getenv("FAIL_THREADS") != nullptr
               ? EAGAIN
               : original<Create>("pthread_create")(thread, attributes, work, argument);
}

extern "C" ssize_t read(int file, void* buffer, size_t size) {
    const char* const first = std::getenv("FAIL_READ");
    if (first != nullptr && isNamed(file)) {
        const off_t left = std::atoll(first) - lseek(file, 0, SEEK_CUR);
        if (left <= 0) {
            errno = EIO;
            return -1;
        }
        size = std::min(size, static_cast<size_t>(left));
    }
    return original<ssize_t (*)(int, void*, size_t)>("read")(file, buffer, size);
}

extern "C" int close(int file) {
    const bool fails = std::getenv("FAIL_CLOSE") != nullptr && isNamed(file);
    const int result = original<int (*)(int)>("close")(file);
    if (fails) {
        errno = ENOSPC;
        return -1;
    }
    return result;
}

extern "C" int rename(const char* from, const char* to) noexcept {
    const char* const fails = std::getenv("FAIL_RENAME");
    if (fails != nullptr && isNamed(std::string_view(to))) {
        if (fails == std::string_view("kill")) {
            kill(getpid(), SIGKILL);
        }
        errno = EROFS;
        return -1;
    }
    return original<int (*)(const char*, const char*)>("rename")(from, to);
}
