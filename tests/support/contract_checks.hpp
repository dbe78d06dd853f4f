// SPDX-License-Identifier: MIT
// What the include promises whatever it is given: bad input is a miss with everything written and nothing
// non-finite, and a change of scale by powers of two changes no bit. Whoever can trace rays can run the
// checks: each returns a sentence about the first answer that is wrong, or nothing.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "trace/tracer.hpp"

namespace raytorus::test {

/// The answers to at most contractRays rays at a torus, as a row of floats.
using AnswerRays = std::function<std::vector<float>(trace::Query, const reference::Torus&,
                                                    const std::vector<trace::TraceRay>&)>;
inline constexpr std::size_t contractRays = 512;

struct ContractCheck {
    const char* name;
    std::string (*fault)(const AnswerRays& answer);
};

/// All of them.
std::span<const ContractCheck> contractChecks();

}  // namespace raytorus::test
