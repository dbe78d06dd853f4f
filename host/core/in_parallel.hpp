// SPDX-License-Identifier: MIT
// A loop over independent items, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace raytorus {

/// work(from, to) for as many parts of 0 ... count - 1 as there are threads, at the same time.
void inParallel(unsigned threads, std::size_t count,
                const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace raytorus
