// SPDX-License-Identifier: MIT
#include "core/descriptor.hpp"

#include <unistd.h>

#include <cerrno>

namespace raytorus {

ssize_t readAll(int file, std::span<std::byte> room) {
    std::size_t done = 0;
    while (done < room.size()) {
        const ssize_t got = ::read(file, room.data() + done, room.size() - done);
        if (got == 0) {
            break;
        }
        if (got > 0) {
            done += static_cast<std::size_t>(got);
        } else if (errno != EINTR) {
            return -1;
        }
    }
    return static_cast<ssize_t>(done);
}

bool writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

}  // namespace raytorus
