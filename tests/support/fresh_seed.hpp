// SPDX-License-Identifier: MIT
// The seed of this run's random rays: fresh each time, printed, and to be had again by RAYTORUS_SEED.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <random>

namespace raytorus::test {

inline std::uint64_t freshSeed() {
    static const std::uint64_t seed = [] {
        const char* given = std::getenv("RAYTORUS_SEED");
        const std::uint64_t value =
            given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device()();
        fmt::print("RAYTORUS_SEED={}\n", value);
        return value;
    }();
    return seed;
}

}  // namespace raytorus::test
