// SPDX-License-Identifier: MIT
#include "failing_rename.hpp"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>

namespace {

std::string failingEnd;  // empty: none fails
bool kills = false;

}  // namespace

// Before that of the C library.
extern "C" int rename(const char* from, const char* to) noexcept {
    if (!failingEnd.empty() && std::string_view(to).ends_with(failingEnd)) {
        if (kills) {
            kill(getpid(), SIGKILL);
        }
        errno = EROFS;
        return -1;
    }
    return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0U));
}

namespace raytorus::test {

FailingRename::FailingRename(const std::string& end) {
    failingEnd = end;
}

FailingRename::~FailingRename() {
    failingEnd.clear();
}

void killAtRename(const std::string& end) {
    failingEnd = end;
    kills = true;
}

}  // namespace raytorus::test
