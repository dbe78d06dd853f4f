// SPDX-License-Identifier: MIT
// Work that may take all memory, never end or crash, done in a process of its own, which has limits of both
// and takes nobody with it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace raytorus::compile {

struct ChildLimits {
    /// More than was there when it began.
    std::size_t memoryBytes = std::size_t{2} << 30U;
    std::chrono::milliseconds time{20'000};
};

/// What the work calls with each message: bytes, as many as it likes.
using Tell = std::function<void(std::string_view)>;

/// Does the work in a copy of this process, and hands each message on to `hear` here, in the calling thread,
/// as it comes. Returns when the child has ended: nothing if it did its work to the end, or why not, as what
/// the work does: "takes more than 2 GiB of memory". What was told before has been heard then, too.
///
/// In the child there is only the calling thread, and one with a stack of 1 GiB that does the work: of it,
/// only what is used takes memory. Where the system refuses such a thread, the calling one does it. Locks
/// that other threads held stay locked. Memory allocation works. Exceptions must not leave `work`. The child
/// ends with this process, whatever ends it, and does nothing that this process does at a signal or at its
/// end.
///
/// Throws Error{OutOfMemory} where the system allows no more processes, and what `hear` throws.
[[nodiscard]] std::string runInChild(const std::function<void(const Tell&)>& work,
                                     const std::function<void(std::string_view)>& hear,
                                     const ChildLimits& limits);

}  // namespace raytorus::compile
