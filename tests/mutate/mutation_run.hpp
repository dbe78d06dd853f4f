// SPDX-License-Identifier: MIT
// Every mutation before every suite, several at a time, each on a device of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "gpu/context.hpp"
#include "mutate/golden_suite.hpp"
#include "mutate/number_suite.hpp"
#include "mutate/outcome.hpp"

namespace raytorus::mutate {

struct RunOptions {
    std::filesystem::path folder;  ///< for the changed shaders, a folder a mutation
    gpu::ContextOptions device;
    RayChoice rays;
    unsigned jobs = 0;  ///< mutations at a time; 0: as many as there are processors
    /// Hears each outcome, in the order of the mutations, as soon as it and all before it are there.
    std::function<void(const Outcome&)> report;
};

/// The shaders as they are, before every suite in full. Throws Error{Internal} if any catches them: then its
/// verdicts on the others are worth nothing.
void requireUnchangedPasses(GoldenSuite& goldens, const RunOptions& options);

/// In the order of the mutations. Throws what any of them threw: a run with a stale row ends.
std::vector<Outcome> runMutations(std::span<const Mutation> mutations, GoldenSuite& goldens,
                                  const RunOptions& options);

}  // namespace raytorus::mutate
