// SPDX-License-Identifier: MIT
// Rays in batches, so that reading, answering and writing go on at the same time.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace raytorus::cli {

/// What is done to a batch. There are two places for batches, 0 and 1, which take turns.
struct BatchStages {
    /// Reads rays into a place and returns how many; none at the end.
    std::function<std::size_t(std::size_t place)> read;
    /// Begins to answer so many rays of a place.
    std::function<void(std::size_t place, std::size_t count)> start;
    /// Waits for the answers, which stay until the next start in the same place.
    std::function<std::span<const float>(std::size_t place)> finish;
    /// Writes answers. Called in a thread of its own.
    std::function<void(std::span<const float>)> write;
};

/// Takes all rays through the stages, in order: while a batch is answered, the next one is read and the one
/// before it is written. Throws what a stage throws; of several at once, what would have come first with one
/// stage after the other.
void runBatches(const BatchStages& stages);

}  // namespace raytorus::cli
