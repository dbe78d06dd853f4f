// SPDX-License-Identifier: MIT
// The numeric tests as judges of changed shaders: the contract's checks, the surface functions' checks, and
// the verifier's thresholds of both tiers on rays of every class.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gpu/context.hpp"
#include "mutate/mutant.hpp"

namespace raytorus::mutate {

struct RayChoice {
    std::uint64_t seed = 1;
    std::uint64_t perGroup = 500;
};

/// Without a mutant's change in trace.comp (with TORUS_FAST: fastRays), probe.comp or scene.frag the checks
/// of that shader are left out.
struct Asked {
    bool rays = true;
    bool fastRays = true;
    bool surface = true;
    bool pictures = true;

    [[nodiscard]] bool any() const { return rays || fastRays || surface || pictures; }
};

/// The first check that fails with the mutant's shaders, and what it says; nothing if each passes.
std::optional<std::string> caughtByNumbers(gpu::Context& context, const Mutant& mutant, const RayChoice& rays,
                                           const Asked& asked = {});

}  // namespace raytorus::mutate
