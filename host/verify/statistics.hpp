// SPDX-License-Identifier: MIT
// What became of many rays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "judge/histogram.hpp"
#include "judge/judge.hpp"

namespace raytorus::verify {

/// A ray to show, and why.
struct Example {
    judge::Fault fault;
    reference::Torus torus;
    reference::Ray ray;
};

/// A distribution of errors, and the ray with the largest.
struct Errors {
    judge::Histogram histogram;
    reference::Torus worstTorus{};
    reference::Ray worstRay{};

    void add(double value, const reference::Torus& torus, const reference::Ray& ray);
    void merge(const Errors& other);
};

struct Statistics {
    std::uint64_t rays = 0;
    std::uint64_t unclear = 0;  ///< not judged: too near a tangent, or with an end too near the surface
    std::uint64_t hitting = 0;  ///< judged rays with at least one hit
    std::array<std::uint64_t, judge::faultKinds> faults{};  ///< by Fault; [None] counts the right ones
    std::vector<Example> examples;                          ///< the first faults, at most `maxExamples`
    Errors position;
    Errors t;
    Errors surface;

    static constexpr std::size_t maxExamples = 5;

    [[nodiscard]] std::uint64_t judged() const { return rays - unclear; }
    [[nodiscard]] std::uint64_t faultsOf(judge::Fault fault) const {
        return faults[static_cast<std::size_t>(fault)];
    }
    [[nodiscard]] std::uint64_t faultCount() const { return judged() - faultsOf(judge::Fault::None); }

    void add(const reference::Torus& torus, const reference::Ray& ray, bool hits,
             const judge::Judgement& judgement);
    void merge(const Statistics& other);
};

}  // namespace raytorus::verify
