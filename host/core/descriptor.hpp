// SPDX-License-Identifier: MIT
// Reads and writes of an open file's descriptor that do not end early: by itself the system may take or give
// less than is asked for, and a signal may interrupt it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>

namespace raytorus {

/// Fills the room, but at the end of the file. How many bytes there are, or -1 and errno.
ssize_t readAll(int file, std::span<std::byte> room);

/// Whether all was written; if not, errno says why.
bool writeAll(int file, std::span<const std::byte> bytes);

}  // namespace raytorus
