// SPDX-License-Identifier: MIT
#include "core/in_parallel.hpp"

#include <thread>
#include <vector>

namespace raytorus {

void inParallel(unsigned threads, std::size_t count,
                const std::function<void(std::size_t, std::size_t)>& work) {
    std::vector<std::jthread> running;
    for (unsigned i = 0; i < threads; ++i) {
        running.emplace_back(work, count * i / threads, count * (i + 1) / threads);
    }
}

}  // namespace raytorus
